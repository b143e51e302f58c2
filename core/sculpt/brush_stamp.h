// A grey image that a brush presses into the surface: 1 works fully, 0 not at all.
//
// The image fills the square around the brush, its longer side the whole of it; beyond its edges it is 0. Between
// pixels it is the quadratic B-spline of them, which has a continuous slope, so that what it displaces has continuous
// normals. Half-sized copies (box filter) keep an image that is finer than the surfels from turning into noise.
#pragma once

#include "core/base/vec.h"

#include <vector>

namespace sculpt {

class BrushStamp {
  public:
    static constexpr int maxSide = 8192;

    /// Rows from top to bottom, values 0 to 1. REQUIRES: values.size() == width * height, both 1 to maxSide.
    BrushStamp(int width, int height, std::vector<float> values);

    struct Value {
        float value = 0;      ///< 0 to 1
        float du = 0, dv = 0; ///< its exact derivatives
    };
    /// At u to the right and v upwards, -1 to 1 across the brush. `level`: how often halved, 0 to levels() - 1.
    Value at(float u, float v, int level = 0) const;

    int levels() const { return static_cast<int>(m_levels.size()); }
    /// The finest level whose pixels are at least `size` (in radii) wide; the last one where none is.
    int levelFor(float size) const;

    bool operator==(const BrushStamp& o) const { return m_levels.front() == o.m_levels.front(); }

  private:
    struct Level {
        int width, height;
        std::vector<float> values;
        float pixel(int x, int y) const;
        bool operator==(const Level&) const = default;
    };
    static Level halved(const Level& fine);
    std::vector<Level> m_levels;
};

} // namespace sculpt
