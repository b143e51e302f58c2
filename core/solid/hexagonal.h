// A hexagonal layout of spacing 1 (process/README 1.1): from row to row, and along a row.
#pragma once

namespace solid {

constexpr double rowStep = 0.9306, alongStep = 1 / rowStep;

} // namespace solid
