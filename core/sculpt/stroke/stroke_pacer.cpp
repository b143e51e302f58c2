#include "core/sculpt/stroke/stroke_pacer.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// Part that the newest dabs have in what one takes.
constexpr double newest = 0.4;
/// Parts of a long way at most.
constexpr double mostParts = 64;

StrokePacer::StrokePacer(const StrokeSettings& settings) : m_settings(settings) {}

/// How many dabs the engine will make, about: what the settings say of distance and time.
double StrokePacer::dabsBetween(const StrokeSample& a, const StrokeSample& b, float depth) const {
    using enum StrokeMethod;
    const bool held = holds(tool(m_settings.tool));
    if (!held && m_settings.method == Airbrush)
        return std::max(0.0, double(b.seconds) - double(a.seconds)) * double(m_settings.rate);
    if (!held && m_settings.method != Space)
        return 1;
    const double step = double(held ? std::min(m_settings.spacing, 0.1f) : m_settings.spacing);
    return double(distance(a.ray.at(depth), b.ray.at(depth))) / (step * double(m_settings.radius));
}

double StrokePacer::expectedSeconds(std::span<const StrokeSample> waiting, std::optional<float> depth) const {
    double dabs = 0;
    const StrokeSample* before = m_last ? &*m_last : nullptr;
    for (const StrokeSample& sample : waiting) {
        dabs += before && depth ? dabsBetween(*before, sample, *depth) : 1;
        before = &sample;
    }
    return dabs * m_dabSeconds;
}

std::vector<StrokeSample> StrokePacer::paced(std::span<const StrokeSample> waiting, std::optional<float> depth) {
    if (waiting.empty())
        return {};
    if (lastOnly(m_settings) && m_last) { // what lies between has no say
        m_last = waiting.back();
        return {waiting.back()};
    }
    const ToolRow& row = tool(m_settings.tool);
    const auto stride = static_cast<float>(
        std::clamp(expectedSeconds(waiting, depth) / pieceSeconds, 1.0, double(StrokeSample::maxStride)));
    const bool dots = !holds(row) && m_settings.method == StrokeMethod::Dots;
    const bool skips = dots || row.motion == Motion::Drag; // what is held may cut corners
    const std::size_t every = skips ? static_cast<std::size_t>(std::ceil(stride)) : 1;
    std::vector<StrokeSample> out;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        if (m_last && (waiting.size() - 1 - i) % every != 0)
            continue;
        StrokeSample sample = waiting[i];
        sample.stride = holds(row) || !m_last ? 1 : stride;
        int parts = 1;
        if (m_last && depth && !dots) {
            const double seconds = dabsBetween(*m_last, sample, *depth) * m_dabSeconds / double(sample.stride);
            parts = static_cast<int>(std::clamp(std::ceil(seconds / sliceSeconds), 1.0, mostParts));
        }
        for (int k = 1; k < parts; ++k)
            out.push_back(between(*m_last, sample, static_cast<float>(k) / static_cast<float>(parts)));
        out.push_back(sample);
        m_last = sample;
    }
    return out;
}

void StrokePacer::took(double seconds, int dabs) {
    if (dabs < 1)
        return;
    const double one = seconds / dabs;
    m_dabSeconds = m_dabSeconds == 0 ? one : m_dabSeconds + newest * (one - m_dabSeconds);
}

} // namespace sculpt
