// A point-sampled cell complex [Adamson07, 9]: patches, curves and points, each sampled by points of its own, glued to
// each other by explicit connectivity. The second way to sharp edges, beside labels (cells/README): exact for open
// patches with designed boundaries.
//
//     complex.h             the cells and their points
//     cell_frame.h          the plane or line of a cell at a place, pulled to its attached boundary
//     foot_on_cell.h        the recursive projection onto one cell, and where cells end
//     complex_projection.h  onto the whole complex; f and its gradient
//     complex_rays.h        rays
//
// Float64 only, and made for being right: some hundred evaluations for a ray. A value, cheap to copy; all functions are
// const and may run on any thread.
#pragma once

#include "core/surface/surface.h"

#include <optional>

namespace complexes {

struct Cell {
    int dimension = 2;
    std::vector<std::uint32_t> boundary;   ///< by number; no cell twice
    surface::Surface own;                  ///< its points alone; empty for patches that only their curves hold
    bool oriented = false;                 ///< its points have normals with a common side
    base::Vec3d centre;                    ///< mean of its points, else of those of its boundary
    base::Box3d bounds;                    ///< of its points and of those of its boundary, by their supports
    std::vector<std::uint32_t> sharedEnds; ///< of a patch: points in which its curves end
    std::vector<std::uint32_t> tangents;   ///< prescribed ones that bind it
    bool bounding = false;                 ///< it is part of the boundary of another one
};

class Complex {
  public:
    /// Nothing for models of another manifold. Throws base::Error where the cells break a rule of complexes/README 1,
    /// or a point or curve has no sample.
    static std::optional<Complex> of(const surface::Surface& surface);

    const surface::Surface& surface() const { return m_surface; }
    const std::vector<Cell>& cells() const { return *m_cells; }
    const Cell& operator[](std::uint32_t cell) const { return (*m_cells)[cell]; }
    const std::vector<surface::PrescribedTangent>& tangents() const {
        return m_surface.definition().connectivity->tangents;
    }
    surface::Weight weight() const { return m_surface.definition().weight; }
    /// Where a cell of dimension 0 is.
    base::Vec3d place(std::uint32_t point) const { return (*m_cells)[point].centre; }
    /// How far a cell of dimension 0 pulls what ends in it, in model units.
    double reach(std::uint32_t point) const;

  private:
    surface::Surface m_surface;
    std::shared_ptr<const std::vector<Cell>> m_cells;
};

/// A cell pulls those that it bounds from so near on, in units of its own h (complexes/README 2).
constexpr double reachOfUnit = 2.5 / 3.5;

} // namespace complexes
