// Heights on a grid, with a hole in it that takes after what is around (solid/README 1.5). Inside this room only.
#pragma once

#include <cstdint>
#include <vector>

namespace solid {

/// Row by row. Cells are known, to be found, or of no account.
struct HeightGrid {
    enum class Cell : std::uint8_t { None, Known, Wanted };

    int width = 0, height = 0;
    std::vector<double> values;
    std::vector<Cell> cells;

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

/// The lag, in cells, at which known heights have nothing in common any more: a quarter of their wavelength. At most
/// `most`.
double correlationLength(const HeightGrid& grid, int most);

/// Fills wanted cells from the rim inwards by pieces of what is known, each the one that goes on best from what is
/// there already. False, and nothing changed, where too few pieces are known whole. Deterministic; throws
/// base::Cancelled by the scope.
bool synthesise(HeightGrid& grid);

} // namespace solid
