// Cells beside creases looked at once more (cells/README 7.3): surfels that lie on the patch across belong there, and
// normals are those of one's own side.
#pragma once

#include "core/cells/creases/surfel_links.h"

#include <map>
#include <optional>
#include <set>

namespace cells {

class CellRefit {
  public:
    /// `noise` in spacings. `normals` tell sides only. All outlive this.
    CellRefit(SurfelLinks& links, std::span<std::uint32_t> cells, std::span<const std::uint32_t> faces,
              std::span<const base::Vec3f> normals, double noise);

    /// Moves surfels beside creases to the cell across where its patch is clearly nearer; links follow. In parallel.
    void reassign();
    /// Takes back creases within faces whose sides turn by less than 15 degrees from each other: noise had cut there.
    /// Cells of a face that are left without a crease in it become one.
    void takeBackFlat();
    /// The face of a surfel: that of its cell, which may be another one by now.
    std::uint32_t faceOf(std::uint32_t i) const { return m_faceOf.at(m_cells[i]); }
    /// The surfels' normals, where creases are near those of their own side: unless they are nearly that already, or
    /// there is no edge yet.
    std::vector<base::Vec3f> ownNormals() const;

  private:
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    void findPairs();
    bool parted(std::uint32_t a, std::uint32_t b) const { return a != b && m_pairs.contains(std::minmax(a, b)); }
    bool atCorner(std::uint32_t i) const;
    std::uint32_t betterCell(std::uint32_t i) const;
    base::Vec3d sideOf(std::span<const std::uint32_t> members) const;
    /// Normals of both sides of the nearest crease; nothing without one, or where few surfels tell.
    struct Sides {
        std::uint32_t other; ///< cell across
        base::Vec3d here, beyond;
    };
    std::optional<Sides> sidesAt(std::uint32_t i) const;
    base::Vec3f ownNormal(std::uint32_t i) const;
    void joinFree();

    SurfelLinks& m_links;
    std::span<std::uint32_t> m_cells;
    std::span<const base::Vec3f> m_normals;
    double m_noise;
    std::map<std::uint32_t, std::uint32_t> m_faceOf; ///< of each cell
    std::set<Pair> m_pairs;                          ///< of cells with creases between them
    std::vector<std::uint8_t> m_atCorner;            ///< of each surfel
};

} // namespace cells
