// A set of an image's tiles, and the quick question whether bounds touch one of them.
#pragma once

#include "core/render/view_frame.h"

#include <cstdint>
#include <vector>

namespace render {

constexpr int tileWidth = 32, tileHeight = 32;

class TileMask {
  public:
    /// None of the image's tiles.
    explicit TileMask(const ViewFrame& view);

    int columns() const { return m_columns; }
    /// Adds all tiles that the bounds overlap. Ends what `close` began.
    void add(const ScreenBounds& bounds);
    /// To be called between the last `add` and the first `touches`.
    void close();
    /// REQUIRES: closed.
    bool touches(const ScreenBounds& bounds) const;
    /// Their numbers, row by row from the top, ascending.
    std::vector<std::uint32_t> tiles() const;
    /// And of those that come within some pixels of one.
    std::vector<std::uint32_t> tilesWithin(int pixels) const;

  private:
    std::size_t at(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column);
    }
    int m_columns, m_rows;
    std::vector<std::uint8_t> m_in;
    std::vector<int> m_sums; ///< of rows and columns before: one row and column more than tiles
};

} // namespace render
