#include "core/render/effects/pixel_geometry.h"

#include <algorithm>

namespace render {

void PixelGeometry::fillMargin() {
    for (std::vector<float>& plane : m_planes) {
        float* first = plane.data() + at(0) - m_margin;
        for (int row = 0; row < m_height; ++row) {
            float* line = first + static_cast<std::size_t>(row) * m_stride;
            const int end = m_margin + m_width;
            std::fill(line, line + m_margin, line[m_margin]);
            std::fill(line + end, line + m_stride, line[end - 1]);
        }
        const float* last = first + static_cast<std::size_t>(m_height - 1) * m_stride;
        for (int row = 0; row < m_margin; ++row) {
            std::copy(first, first + m_stride, plane.data() + static_cast<std::size_t>(row) * m_stride);
            std::copy(last, last + m_stride,
                      plane.data() + static_cast<std::size_t>(m_height + m_margin + row) * m_stride);
        }
    }
}

} // namespace render
