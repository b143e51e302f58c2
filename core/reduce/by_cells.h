// Models with cells (cells/README): each cell is the surface of its own surfels alone, which ends where another cuts it
// off. The surface of all of them together is rounded at creases, so each is reduced by itself (reduce/README 8).
#pragma once

#include "core/reduce/reduce.h"

namespace reduce {

/// Does a surface have cells?
bool hasCells(const surface::Surface& model);

/// As `reduceBy` for models with cells, to a count, which is exact, or an error, which all of the model's surfels
/// together keep. Of cells that nothing can be fitted to, as they have hardly any surface, surfels are picked to the
/// count (Report::picked), or all of them stay to the error. The report is of the cells, each against itself: p999 is
/// that of the worst. Throws base::Error where a count leaves a cell without a surface or no count keeps the error;
/// base::Cancelled. REQUIRES: hasCells(model).
Reduced reduceCells(const surface::Surface& model, const Wish& wish, const base::Progress& progress = {});

} // namespace reduce
