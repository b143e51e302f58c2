// Products with the rows of the fit, in lanes: the innermost loop of its solver (reduce/README 4.3). Internal to the
// fit.
#pragma once

#include "core/reduce/normal_equations.h"

namespace reduce {

/// Numbers of a site, whatever its unknowns are: those behind mean nothing.
constexpr std::size_t siteLanes = 8;

/// sum += unit^2 a (a.x) for each row a of the piece. `x` and `sum` hold `siteLanes` numbers for each of the piece's
/// sites; those of `x` behind the unknowns are 0. The same bits whatever the processor.
template <int unknowns>
void addRowProducts(const FitPiece<unknowns>& piece, std::span<const float> x, std::span<float> sum);

} // namespace reduce
