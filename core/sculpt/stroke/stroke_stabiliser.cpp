#include "core/sculpt/stroke/stroke_stabiliser.h"

namespace sculpt {

/// Pieces of a rope's length in which the pointer is followed: the brush is off the smooth curve by a 500th of it.
constexpr float pieces = 16;
/// Between two samples, a bound for those that sweep far beyond the model.
constexpr std::size_t mostPieces = 4096;

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

std::vector<Stabiliser::Step> Stabiliser::followAll(const StrokeSample& pointer, std::optional<float> depth) {
    std::vector<Step> out;
    if (m_rope > 0 && depth && m_pointer) {
        if (!m_way)
            m_way.emplace().begin(*m_pointer, *depth, m_rope / pieces);
        for (m_way->add(pointer); m_way->length() >= 1 && out.size() < mostPieces; m_way->leave(1))
            out.push_back(follow(m_way->at(1), depth));
    }
    m_pointer = pointer;
    const std::optional<base::Rayf> brush = m_brush;
    out.push_back(follow(pointer, depth));
    if (m_way && m_way->length() < 1)
        m_brush = brush; // the next piece goes on where the last one ended
    else if (m_way)
        m_way->leave(m_way->length());
    return out;
}

} // namespace sculpt
