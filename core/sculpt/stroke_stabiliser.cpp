#include "core/sculpt/stroke_stabiliser.h"

namespace sculpt {

Stabiliser::Step Stabiliser::follow(const StrokeSample& pointer, std::optional<float> depth) {
    if (!(m_rope > 0))
        return {pointer, true};
    if (!depth || !m_brush) {
        m_brush = pointer.ray;
        return {pointer, true};
    }
    StrokeSample out = pointer;
    const float apart = distance(pointer.ray.at(*depth), m_brush->at(*depth));
    const bool taut = apart > m_rope;
    if (taut) {
        StrokeSample brush = pointer;
        brush.ray = *m_brush;
        m_brush = between(brush, pointer, 1 - m_rope / apart).ray;
    }
    out.ray = *m_brush;
    return {out, taut};
}

} // namespace sculpt
