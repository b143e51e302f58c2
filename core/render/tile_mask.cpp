#include "core/render/tile_mask.h"

#include <algorithm>

namespace render {

TileMask::TileMask(const ViewFrame& view)
    : m_columns((view.width + tileWidth - 1) / tileWidth), m_rows((view.height + tileHeight - 1) / tileHeight),
      m_in(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows)) {}

void TileMask::add(const ScreenBounds& b) {
    for (int row = b.top / tileHeight; row <= b.bottom / tileHeight; ++row)
        for (int column = b.left / tileWidth; column <= b.right / tileWidth; ++column)
            m_in[at(row, column)] = 1;
}

void TileMask::close() {
    const std::size_t stride = static_cast<std::size_t>(m_columns) + 1;
    m_sums.assign(stride * (static_cast<std::size_t>(m_rows) + 1), 0);
    for (int row = 0; row < m_rows; ++row)
        for (int column = 0; column < m_columns; ++column) {
            int* corner = m_sums.data() + static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column);
            corner[stride + 1] = corner[stride] + corner[1] - corner[0] + m_in[at(row, column)];
        }
}

bool TileMask::touches(const ScreenBounds& b) const {
    const std::size_t stride = static_cast<std::size_t>(m_columns) + 1;
    const auto sum = [&](int row, int column) {
        return m_sums[static_cast<std::size_t>(row) * stride + static_cast<std::size_t>(column)];
    };
    const int left = b.left / tileWidth, right = b.right / tileWidth + 1;
    const int top = b.top / tileHeight, bottom = b.bottom / tileHeight + 1;
    return sum(bottom, right) - sum(bottom, left) - sum(top, right) + sum(top, left) > 0;
}

std::vector<std::uint32_t> TileMask::tilesWithin(int pixels) const {
    TileMask wide = *this;
    const int columns = (pixels + tileWidth - 1) / tileWidth, rows = (pixels + tileHeight - 1) / tileHeight;
    for (int row = 0; row < m_rows; ++row)
        for (int column = 0; column < m_columns; ++column)
            if (m_in[at(row, column)])
                for (int y = std::max(0, row - rows); y <= std::min(m_rows - 1, row + rows); ++y)
                    for (int x = std::max(0, column - columns); x <= std::min(m_columns - 1, column + columns); ++x)
                        wide.m_in[at(y, x)] = 1;
    return wide.tiles();
}

std::vector<std::uint32_t> TileMask::tiles() const {
    std::vector<std::uint32_t> out;
    for (std::size_t t = 0; t < m_in.size(); ++t)
        if (m_in[t])
            out.push_back(static_cast<std::uint32_t>(t));
    return out;
}

} // namespace render
