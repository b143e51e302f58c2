// The edges that a model keeps sharp as curves to be drawn like sections (section_lines.h).
#pragma once

#include "core/base/progress.h"
#include "core/render/overlay/section_lines.h"

namespace render {

/// Throws base::Cancelled.
std::vector<surface::SectionCurve> seamCurves(const surface::Surface& surface, const base::Progress& progress = {});

/// Their parts of which one side at least may face the eye, where there is no depth to tell what is hidden.
std::vector<surface::SectionCurve> facingParts(const std::vector<surface::SectionCurve>& curves, const Camera& camera);

} // namespace render
