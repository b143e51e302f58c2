// Models with cells (cells/README): each cell is the surface of its own surfels alone, which ends where another cuts it
// off. The surface of all of them together is rounded at creases, so each is reduced by itself (reduce/README 8).
#pragma once

#include "core/reduce/reduce.h"

namespace reduce {

/// Does a surface have cells?
bool hasCells(const surface::Surface& model);

/// As `reduceBy` for models with cells, to a count or an error. Surfels of cells that are too small or rough for what
/// is asked stay as they are. The report is of the cells, each against itself: p999 is that of the worst. Throws
/// base::Error where a count leaves a cell without a surface; base::Cancelled. REQUIRES: hasCells(model).
Reduced reduceCells(const surface::Surface& model, const Wish& wish, const base::Progress& progress = {});

} // namespace reduce
