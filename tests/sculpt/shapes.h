// Shapes to sculpt on, and a stroke in one call.
#pragma once

#include "core/sculpt/stroke/stroke.h"
#include "process/even_shapes.h"

namespace test {

/// Runs a whole stroke.
inline surface::Surface stroked(const surface::Surface& start, const sculpt::StrokeSettings& settings,
                                const std::vector<sculpt::StrokeSample>& samples, const base::Vec3d& origin = {}) {
    sculpt::Stroke stroke(start, settings, origin);
    for (const sculpt::StrokeSample& sample : samples)
        stroke.add(sample);
    stroke.finish();
    return stroke.surface();
}

} // namespace test
