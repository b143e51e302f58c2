// The surface of a model with cells (cells/README 2): smooth within cells, sharp where they meet.
//
//     CellSurface       a model, and where in it several cells are near each other
//     CellSource        the cells around one place and what each of them says there           cell_source.h
//     local Boolean     which of them is surface                                              local_boolean.h
//     evaluate, intersect, project                                  cell_value.h, cell_rays.h, cell_projection.h
//
// A value, cheap to copy; it holds its version alive. All functions are const and may run on any thread.
#pragma once

#include "core/cells/cell_parts.h"
#include "core/surface/surface.h"

#include <memory>
#include <unordered_map>

namespace cells {

class CellSurface {
  public:
    /// Nothing for models without labels and for curves. Time: that of one query for each cluster, in parallel.
    static std::optional<CellSurface> of(const surface::Surface& surface);

    /// The same at no cost, for few places: nobody has looked where cells are near each other, so that all clusters are
    /// mixed. REQUIRES: labels; it is CellSource that asks, and not CellSourcef.
    static CellSurface unprepared(const surface::Surface& surface, const LabelLayout& labels);

    const surface::Surface& surface() const { return m_surface; }
    const LabelLayout& labels() const { return m_labels; }

    const CellParts& parts() const { return *m_parts; }

    /// May surfels of several cells have weight where the surface near this cluster is? Where none of what a question
    /// meets is mixed, the answer is that of the surface without cells, bit for bit.
    bool mixed(const surfel::SurfelBlock& block, int cluster) const { return (mixed(block) >> cluster & 1u) != 0; }
    /// A bit for each cluster of a block.
    unsigned mixed(const surfel::SurfelBlock& block) const {
        const auto found = m_mixed->find(&block);
        return found == m_mixed->end() ? ~0u : found->second;
    }
    /// Are there mixed clusters on the ray up to t?
    bool mixedAlong(const base::Rayf& ray, float t) const;

  private:
    using Mixed = std::unordered_map<const surfel::SurfelBlock*, unsigned>;

    CellSurface(surface::Surface surface, const LabelLayout& labels)
        : m_surface(std::move(surface)), m_labels(labels) {}

    surface::Surface m_surface;
    LabelLayout m_labels;
    std::shared_ptr<const Mixed> m_mixed; ///< a bit for each cluster
    std::shared_ptr<const CellParts> m_parts;
};

/// What `info` tells.
struct CellCounts {
    std::size_t cells = 0, pairs = 0;    ///< pairs of cells that meet in creases
    std::size_t convex = 0, concave = 0; ///< surfels beside creases
};
/// Zeros for models without labels.
CellCounts countCells(const surfel::SurfelList& surfels);

} // namespace cells
