#include "core/sculpt/stroke/stroke_way.h"

#include <algorithm>

namespace sculpt {

void StrokeWay::begin(const StrokeSample& from, float depth, float step) {
    m_depth = depth, m_step = step;
    if (m_samples.empty())
        m_samples = {from};
    m_samples.front() = from;
    measure();
}

void StrokeWay::add(const StrokeSample& to) {
    // A pointer that rests is one place, however often it says so.
    const std::size_t last = m_samples.size() - 1;
    if (last > 0 && lengthOf(last) == 0 && m_samples.back().ray.at(m_depth) == to.ray.at(m_depth))
        m_samples.pop_back();
    m_samples.push_back(to);
    m_length += lengthOf(m_samples.size() - 1);
}

float StrokeWay::lengthOf(std::size_t piece) const {
    const StrokeSample &from = m_samples[piece - 1], &to = m_samples[piece];
    return distance(to.ray.at(m_depth), from.ray.at(m_depth)) / (m_step * to.stride);
}

void StrokeWay::measure() {
    m_length = 0;
    for (std::size_t piece = 1; piece < m_samples.size(); ++piece)
        m_length += lengthOf(piece);
}

StrokeWay::Place StrokeWay::placeOf(float steps) const {
    for (std::size_t piece = 1; piece < m_samples.size(); ++piece) {
        const float length = lengthOf(piece);
        if (steps <= length && length > 0)
            return {piece, std::max(0.0f, steps / length)};
        steps -= length;
    }
    return {m_samples.size() - 1, 1};
}

StrokeSample StrokeWay::at(float steps) const {
    const Place place = placeOf(steps);
    return place.piece == 0 ? m_samples[0] : between(m_samples[place.piece - 1], m_samples[place.piece], place.u);
}

void StrokeWay::leave(float steps) {
    const Place place = placeOf(steps);
    if (place.piece == 0)
        return;
    const StrokeSample from = at(steps);
    m_samples.erase(m_samples.begin(), m_samples.begin() + static_cast<std::ptrdiff_t>(place.piece) - 1);
    m_samples.front() = from;
    measure();
}

} // namespace sculpt
