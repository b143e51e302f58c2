// Section curves over a picture: the lines where clip planes meet the surface, smooth and of one width, left out where
// another plane cuts them away or something nearer hides them.
#pragma once

#include "core/render/overlay/pen.h"
#include "core/surface/curves/section.h"

namespace render {

/// The curves of each of the camera's planes, in their order.
using SectionCurves = std::vector<std::vector<surface::SectionCurve>>;

/// How a section looks: a line with a darker, wider one below.
struct SectionPen {
    surfel::Colour line = surfel::rgba(255, 176, 64), shade = surfel::rgba(20, 20, 24, 150);
    double shadeWidth = 2.2; ///< times the line's
};

/// Their visible parts, in pixels of the camera's image: runs of points to be joined. With `depth` (of the image that
/// they are drawn over), what is hidden is left out.
std::vector<std::vector<ImagePoint>> sectionLines(const SectionCurves& curves, const Camera& camera,
                                                  const Image* depth = nullptr);
/// Into the image itself; the depth stays.
void drawSections(const SectionCurves& curves, const Camera& camera, Image& image);

} // namespace render
