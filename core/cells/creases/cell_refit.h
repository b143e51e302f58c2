// Cells beside creases looked at once more (cells/README 7.3): surfels that lie on the patch across belong there, and
// normals are those of one's own side.
#pragma once

#include "core/cells/creases/surfel_links.h"

#include <set>

namespace cells {

class CellRefit {
  public:
    /// `noise` in spacings. `normals` tell sides only. All outlive this.
    CellRefit(SurfelLinks& links, std::span<std::uint32_t> cells, std::span<const std::uint32_t> faces,
              std::span<const base::Vec3f> normals, double noise);

    /// Moves surfels beside creases to the cell across where its patch is clearly nearer; links follow. In parallel.
    void reassign();
    /// The surfels' normals, where creases are near those of their own side: unless they are nearly that already, or
    /// there is no edge yet.
    std::vector<base::Vec3f> ownNormals() const;

  private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    void findPairs();
    bool parted(std::uint32_t a, std::uint32_t b) const { return a != b && m_pairs.contains(std::minmax(a, b)); }
    bool atCorner(std::uint32_t i) const;
    std::uint32_t betterCell(std::uint32_t i) const;
    base::Vec3f ownNormal(std::uint32_t i) const;

    SurfelLinks& m_links;
    std::span<std::uint32_t> m_cells;
    std::span<const std::uint32_t> m_faces;
    std::span<const base::Vec3f> m_normals;
    double m_noise;
    std::set<Pair> m_pairs;               ///< of cells with creases between them
    std::vector<std::uint8_t> m_atCorner; ///< of each surfel
};

} // namespace cells
