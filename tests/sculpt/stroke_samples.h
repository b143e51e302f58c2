// Strokes by hand: samples that look straight down.
#pragma once

#include "core/sculpt/stroke/stroke.h"
#include "sculpt/shapes.h"

namespace test {

inline sculpt::StrokeSample down(float x, float y, float seconds = 0, float pressure = 1) {
    return {{{x, y, 5}, {0, 0, -1}}, pressure, seconds};
}

inline sculpt::StrokeSettings settingsOf(const char* tool, float radius,
                                         sculpt::StrokeMethod method = sculpt::StrokeMethod::Space) {
    sculpt::StrokeSettings out;
    out.tool = tool;
    out.radius = radius;
    out.method = method;
    return out;
}

/// How many dabs the stroke makes.
inline int dabsOf(const surface::Surface& start, const sculpt::StrokeSettings& settings,
                  const std::vector<sculpt::StrokeSample>& samples) {
    sculpt::Stroke stroke(start, settings);
    for (const sculpt::StrokeSample& sample : samples)
        stroke.add(sample);
    stroke.finish();
    return stroke.dabs();
}

} // namespace test
