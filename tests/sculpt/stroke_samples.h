// Strokes by hand: samples that look straight down.
#pragma once

#include "core/sculpt/stroke.h"
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

} // namespace test
