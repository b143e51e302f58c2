// The edges that a model keeps sharp as curves to be drawn like sections (section_lines.h).
#pragma once

#include "core/base/progress.h"
#include "core/render/overlay/section_lines.h"

namespace render {

/// Throws base::Cancelled.
std::vector<surface::SectionCurve> seamCurves(const surface::Surface& surface, const base::Progress& progress = {});

} // namespace render
