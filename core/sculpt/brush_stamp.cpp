#include "core/sculpt/brush_stamp.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sculpt {

BrushStamp::BrushStamp(int width, int height, std::vector<float> values) {
    assert(width >= 1 && height >= 1 && width <= maxSide && height <= maxSide);
    assert(values.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    m_levels.push_back({width, height, std::move(values)});
    while (std::max(m_levels.back().width, m_levels.back().height) > 1)
        m_levels.push_back(halved(m_levels.back()));
}

float BrushStamp::Level::pixel(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height)
        return 0;
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
}

/// Means of two by two pixels; an odd last row or column is paired with what lies beyond, which is 0.
BrushStamp::Level BrushStamp::halved(const Level& fine) {
    Level out{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x)
            out.values.push_back(0.25f * ((fine.pixel(2 * x, 2 * y) + fine.pixel(2 * x + 1, 2 * y)) +
                                          (fine.pixel(2 * x, 2 * y + 1) + fine.pixel(2 * x + 1, 2 * y + 1))));
    return out;
}

int BrushStamp::levelFor(float size) const {
    const Level& finest = m_levels.front();
    float pixel = 2 / static_cast<float>(std::max(finest.width, finest.height));
    int level = 0;
    for (; level + 1 < levels() && pixel < size; ++level)
        pixel *= 2;
    return level;
}

/// Weights of the three pixels around place t (its nearest pixel's centre at 0, |t| <= 1/2), and their slopes.
static void spline(float t, float* weight, float* slope) {
    weight[0] = 0.5f * (0.5f - t) * (0.5f - t), slope[0] = t - 0.5f;
    weight[1] = 0.75f - t * t, slope[1] = -2 * t;
    weight[2] = 0.5f * (0.5f + t) * (0.5f + t), slope[2] = t + 0.5f;
}

BrushStamp::Value BrushStamp::at(float u, float v, int level) const {
    const Level& image = m_levels[static_cast<std::size_t>(level)];
    const Level& finest = m_levels.front();
    // Halving an odd side adds half a pixel beyond it: the scale is the finest level's, halved.
    const float scale = std::ldexp(0.5f * static_cast<float>(std::max(finest.width, finest.height)), -level);
    const float halfWidth = std::ldexp(0.5f * static_cast<float>(finest.width), -level),
                halfHeight = std::ldexp(0.5f * static_cast<float>(finest.height), -level);
    const float x = u * scale + halfWidth - 0.5f, y = halfHeight - v * scale - 0.5f; // pixel centres at whole numbers
    const float limit = 2 * static_cast<float>(maxSide);
    if (!(std::abs(x) < limit) || !(std::abs(y) < limit))
        return {};
    const float fx = std::floor(x + 0.5f), fy = std::floor(y + 0.5f);
    float wx[3], wy[3], sx[3], sy[3];
    spline(x - fx, wx, sx);
    spline(y - fy, wy, sy);
    Value out;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
            const float p = image.pixel(static_cast<int>(fx) + i - 1, static_cast<int>(fy) + j - 1);
            out.value += wx[i] * wy[j] * p;
            out.du += sx[i] * wy[j] * p * scale;
            out.dv -= wx[i] * sy[j] * p * scale;
        }
    return out;
}

} // namespace sculpt
