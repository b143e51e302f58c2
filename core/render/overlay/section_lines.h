// Section curves over a picture: the lines where clip planes meet the surface, smooth and of one width, left out where
// another plane cuts them away or something nearer hides them. Other curves on the surface are drawn like them.
#pragma once

#include "core/render/overlay/pen.h"
#include "core/surface/curves/section.h"

#include <span>

namespace render {

/// The curves of each of the camera's planes, in their order.
using SectionCurves = std::vector<std::vector<surface::SectionCurve>>;

/// How a section looks: a line with a darker, wider one below.
struct SectionPen {
    surfel::Colour line = surfel::rgba(255, 176, 64), shade = surfel::rgba(20, 20, 24, 150);
    double shadeWidth = 2.2; ///< times the line's
};

/// Runs of points to be joined, in pixels of the camera's image.
using LineRuns = std::vector<std::vector<ImagePoint>>;

/// Their visible parts. With `depth` (of the image that they are drawn over), what is hidden is left out.
LineRuns sectionLines(const SectionCurves& curves, const Camera& camera, const Image* depth = nullptr);
/// Of curves that are no plane's section: all planes cut them.
LineRuns curveLines(std::span<const surface::SectionCurve> curves, const Camera& camera, const Image* depth = nullptr);
/// Into the image itself; the depth stays.
void drawSections(const LineRuns& lines, Image& image);

} // namespace render
