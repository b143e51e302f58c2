// What small discs about the surfels tell about a view before any ray is cast: where a ray cannot hit the surface, and
// where something stands that the rays on either side of it may have missed (raycast/README 2.4).
//
// For every pixel the nearest depth of discs of radius 0.6 s (s the spacing), with a pyramid of least depths above; and
// the tiles of pixels in which a ball about some surfel is seen, as wide as the surface can reach. Both are hints: the
// surface itself is where the rays say. In parallel; the same bits at any thread count.
#pragma once

#include "core/raycast/cast_pixels.h"
#include "core/raycast/view_lens.h"

namespace raycast {

class SplatGuard {
  public:
    /// REQUIRES: at least the view's columns and rows.
    void look(const surface::Surface& surface, const ImageRays& view, int columns, int rows,
              const base::Progress& progress);

    /// Median spacing of the surfels in view, in pixels.
    double spacingPx() const { return m_spacingPx; }
    /// May the ray of this pixel hit the surface?
    bool reached(Pixel p) const { return m_reached[tileIndex(p)] != 0; }
    /// May every ray of the pixels [column, column + size) x [row, row + size)? Size and pixel are multiples of a power
    /// of two up to 32.
    bool allReached(Pixel p, int size) const;
    /// Does a disc cover a pixel of the square?
    bool anyDisc(Pixel p, int size) const { return nearest(p, size) < none; }
    /// From this depth on a surface is hidden: 1.5 s behind the nearest disc of the square; infinite without one.
    float hiddenFrom(Pixel p, int size) const { return nearest(p, size); }

    static constexpr int largestSquare = 32;

  private:
    static constexpr float none = std::numeric_limits<float>::infinity();
    struct Disc;

    float nearest(Pixel p, int size) const;
    std::size_t tileIndex(Pixel p) const {
        return static_cast<std::size_t>(p.row / m_tile) * static_cast<std::size_t>(m_tileColumns) +
               static_cast<std::size_t>(p.column / m_tile);
    }
    void drawDisc(const Disc& disc, int firstRow, int lastRow);
    void drawBall(const Disc& disc, int firstRow, int lastRow);
    void makeSquares();

    int m_columns = 0, m_rows = 0;
    int m_tile = 4, m_tileColumns = 0, m_tileRows = 0;
    double m_spacingPx = 1;
    std::vector<std::vector<float>> m_nearest; ///< for squares of 1, 2, 4 ... pixels
    std::vector<std::uint8_t> m_reached;
};

} // namespace raycast
