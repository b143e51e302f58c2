// What the surface of a model with cells says at a place: the local Boolean's f, and whose it is (cells/README 3).
#pragma once

#include "core/cells/cell_source.h"

namespace cells {

constexpr std::uint32_t noCell = std::numeric_limits<std::uint32_t>::max();

struct CellValue {
    surface::Evaluationd at;     ///< of the cell that is surface here; near creases f has a bend
    std::uint32_t cell = noCell; ///< noCell where nothing is
    bool mixed = false;          ///< several cells have weight here
};

CellValue evaluate(CellSource& source, const base::Vec3d& x, surface::Need need);
/// Of one place.
CellValue evaluate(const CellSurface& surface, const base::Vec3d& x, surface::Need need);

} // namespace cells
