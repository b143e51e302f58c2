// Newton's iterations of a projection (cells/README 5): the feet of one place on a cell, on the seam of two, and the
// corner of three and more. None of them asks whether what is found is surface.
#pragma once

#include "core/cells/cell_source.h"
#include "core/surface/projection/project.h"

namespace cells {

class Feet {
  public:
    Feet(CellSource& source, const base::Vec3d& x, const surface::ProjectOptions& options)
        : m_source(source), m_x(x), m_options(options) {}

    /// From `start`; nothing where the iteration leaves the cells or does not settle.
    std::optional<base::Vec3d> face(std::uint32_t cell, const base::Vec3d& start);
    std::optional<base::Vec3d> seam(std::uint32_t a, std::uint32_t b, const base::Vec3d& start);
    /// Of three cells: where all are zero. Of more: the place with the least sum of squares.
    std::optional<base::Vec3d> corner(std::span<const std::uint32_t> cells, const base::Vec3d& start);

    int evaluations() const { return m_evaluations; }
    int iterations() const { return m_iterations; }

  private:
    /// Evaluations with gradient at y, of cells that must all be there.
    bool evaluate(std::span<const std::uint32_t> cells, const base::Vec3d& y);
    template <class Step>
    std::optional<base::Vec3d> iterate(std::span<const std::uint32_t> cells, base::Vec3d y, const Step& step);

    CellSource& m_source;
    base::Vec3d m_x;
    surface::ProjectOptions m_options;
    std::vector<surface::Evaluationd> m_at;
    int m_evaluations = 0, m_iterations = 0;
};

} // namespace cells
