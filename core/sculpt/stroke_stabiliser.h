// The lazy rope: the brush hangs on the pointer by a rope and moves only where that is taut, so that a trembling hand
// draws a smooth line.
//
//     b' = b where |p - b| <= rope,    else b' = p + (b - p) rope / |p - b|
//
// p and b are the places of pointer and brush on their rays, both at the depth of the stroke's first contact. A value
// of samples alone: neither time nor frame rate has a say. Until the depth is known the brush is the pointer.
#pragma once

#include "core/sculpt/stroke_sample.h"

#include <optional>

namespace sculpt {

class Stabiliser {
  public:
    explicit Stabiliser(float rope) : m_rope(rope) {} ///< model units; 0: none

    struct Step {
        StrokeSample sample; ///< the brush's ray with the pointer's pressure and time
        bool moved = true;
    };
    /// `depth`: along the rays' unit directions, once the stroke has met the model.
    Step follow(const StrokeSample& pointer, std::optional<float> depth);

  private:
    float m_rope;
    std::optional<base::Rayf> m_brush;
};

} // namespace sculpt
