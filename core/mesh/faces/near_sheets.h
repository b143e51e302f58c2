// Faces that come near themselves (cells/README 1.5): a step whose wall is narrow has one face below and above it where
// both go on into one another round the wall's end. Sums over all samples of the face would mix the two sheets, so that
// one of them becomes a cell and face of its own. Where both touch round the end, they know each other as cells that
// meet there, less and less sharply, as the sides of a crease that ends do.
#pragma once

#include "core/cells/crease_labels.h"
#include "core/mesh/faces/edge_crossings.h"
#include "core/mesh/faces/sample_grid.h"

namespace mesh {

class NearSheets {
  public:
    /// `faces` and `cells` of each sample, cells within faces; the grid finds samples within 2.2 spacings, `support` is
    /// theirs. New numbers begin with `firstNew`.
    NearSheets(const EdgeCrossings& edges, const SampleGrid& grid, std::span<const surfel::Surfel> samples,
               std::span<const std::uint32_t> faces, std::vector<std::uint32_t> cells, double spacing, double support,
               std::uint32_t firstNew);

    const std::vector<std::uint32_t>& cells() const { return m_cells; }
    std::uint32_t faceOf(std::uint32_t sample) const {
        return isNew(m_cells[sample]) ? m_cells[sample] : m_faces[sample];
    }
    /// Appends where new cells touch others of the face that they were.
    void addBorders(std::vector<cells::CreasePiece>& out) const;
    /// Sharpness of these borders: less and less away from the end of what is between both sheets.
    void fade(std::span<cells::Label> labels) const;

  private:
    using Strangers = std::vector<std::vector<std::uint32_t>>;

    bool isNew(std::uint32_t cell) const { return cell >= m_firstNew; }
    /// Those of which an edge of their face is nearer than the grid's radius.
    std::vector<bool> samplesNear(const SampleGrid& wide) const;
    void findLinks();
    /// Of each sample those of its face that are near, but not on ways over its links.
    Strangers strangers() const;
    std::vector<std::uint32_t> unreached(std::uint32_t a, std::vector<std::uint32_t> others) const;
    std::vector<std::vector<std::uint32_t>> pieces(const Strangers& strangers,
                                                   std::vector<std::uint32_t>& pieceOf) const;
    void split(const Strangers& strangers);
    void grow(const std::vector<std::uint32_t>& seeds, const std::vector<std::uint32_t>& before);
    /// fn(b) for samples of the same face around a that a new cell keeps apart from it.
    template <class Fn>
    void forBorderLinks(std::uint32_t a, const Fn& fn) const;

    const EdgeCrossings& m_edges;
    const SampleGrid& m_grid;
    std::span<const surfel::Surfel> m_samples;
    std::span<const std::uint32_t> m_faces;
    double m_spacing, m_support;
    std::uint32_t m_firstNew;
    std::vector<std::uint32_t> m_cells;
    std::vector<std::vector<std::uint32_t>> m_links; ///< over no edge and through no matter, of samples near edges
};

} // namespace mesh
