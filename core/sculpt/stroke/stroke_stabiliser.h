// The lazy rope: the brush hangs on the pointer by a rope and moves only where that is taut, so that a trembling hand
// draws a smooth line.
//
//     b' = b where |p - b| <= rope,    else b' = p + (b - p) rope / |p - b|
//
// p and b are the places of pointer and brush on their rays, both at the depth of the stroke's first contact. A value
// of samples alone: neither time nor frame rate has a say. Until the depth is known the brush is the pointer.
//
// What the rope makes of a way depends on how it is cut: the brush goes straight while the pointer turns. So the
// pointer is followed in pieces of a part of the rope, counted from where the stroke began, however many samples it
// came in.
#pragma once

#include "core/sculpt/stroke/stroke_way.h"

#include <optional>
#include <vector>

namespace sculpt {

class Stabiliser {
  public:
    explicit Stabiliser(float rope) : m_rope(rope) {} ///< model units; 0: none

    struct Step {
        StrokeSample sample; ///< the brush's ray with the pointer's pressure and time
        bool moved = true;
    };
    /// One straight move of the pointer. `depth`: along the rays' unit directions, once the stroke has met the model.
    Step follow(const StrokeSample& pointer, std::optional<float> depth);
    /// The same piece by piece; the last is where the brush is when the pointer is there.
    std::vector<Step> followAll(const StrokeSample& pointer, std::optional<float> depth);

  private:
    float m_rope;
    std::optional<base::Rayf> m_brush;
    std::optional<StrokeSample> m_pointer; ///< the last, until there is a way
    std::optional<StrokeWay> m_way;        ///< of the pointer, from the end of the last piece
};

} // namespace sculpt
