// What `query` answers on models with cells (core/cells/cell_surface.h): where several cells are near, their surface in
// place of the smooth one.
#pragma once

#include "app/query_columns.h"

namespace app {

class CellAnswers {
  public:
    /// Nothing for models without cells.
    static std::optional<CellAnswers> of(const surface::Surface& surface, const Question& question);

    /// Puts in `out`, which holds the answers of the smooth surface, what cells say otherwise. In double, in parallel.
    void answer(const Question& question, std::span<const base::Vec3d> x, std::span<Answer> out) const;

  private:
    explicit CellAnswers(cells::CellSurface surface) : m_surface(std::move(surface)) {}

    cells::CellSurface m_surface;
    std::optional<cells::CellSurface> m_wide; ///< with the supports of curvature, where that is asked for
};

} // namespace app
