// What effects know of a picture: per pixel nearness and normal, as planes with a margin all around, so that a pixel's
// neighbours can be read without asking whether they exist. Pixels of the margin repeat the image's nearest.
#pragma once

#include "core/render/view_frame.h"
#include "core/surfel/surfel.h"

#include <vector>

namespace render {

/// Nearness (screen_effects.h) of what is infinitely far: no surface.
constexpr float nowhere = 0, nowhereParallel = -1e18f;
inline float nowhereOf(const ViewFrame& view) {
    return view.parallel ? nowhereParallel : nowhere;
}

class PixelGeometry {
  public:
    /// Keeps its content where nothing changes; else all of it is undefined.
    void resize(int width, int height, int margin) {
        if (width == m_width && height == m_height && margin == m_margin)
            return;
        m_width = width, m_height = height, m_margin = margin;
        m_stride = static_cast<std::size_t>(width + 2 * margin + vectorRoom);
        for (std::vector<float>& plane : m_planes)
            plane.assign(m_stride * static_cast<std::size_t>(height + 2 * margin), 0.0f);
    }
    bool empty() const { return m_width == 0; }
    std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(m_stride); }
    /// Of column 0; columns from -margin to width + margin may be read.
    float* nearness(int row) { return m_planes[0].data() + at(row); }
    const float* nearness(int row) const { return m_planes[0].data() + at(row); }
    /// Component 0 to 2 of the unit normal in camera coordinates: x right, y up, z towards the eye.
    float* normal(int k, int row) { return m_planes[static_cast<std::size_t>(k) + 1].data() + at(row); }
    const float* normal(int k, int row) const { return m_planes[static_cast<std::size_t>(k) + 1].data() + at(row); }
    /// To be called when the pixels have changed.
    void fillMargin();

  private:
    static constexpr int vectorRoom = 16; ///< vectors may run past a row's end
    std::size_t at(int row) const {
        return static_cast<std::size_t>(row + m_margin) * m_stride + static_cast<std::size_t>(m_margin);
    }
    int m_width = 0, m_height = 0, m_margin = 0;
    std::size_t m_stride = 0;
    std::vector<float> m_planes[4];
};

} // namespace render
