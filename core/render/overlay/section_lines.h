// Section curves over a picture: the lines where clip planes meet the surface, smooth and of one width, left out where
// another plane cuts them away or something nearer hides them.
#pragma once

#include "core/render/renderer.h"
#include "core/surface/curves/section.h"

class QPainter;

namespace render {

/// The curves of each of the camera's planes, in their order.
using SectionCurves = std::vector<std::vector<surface::SectionCurve>>;

/// In device pixels of the camera's image, of that width. With `depth` (of the image that it paints over), hidden parts
/// are left out.
void paintSections(QPainter& painter, const SectionCurves& curves, const Camera& camera, double widthPx,
                   const Image* depth = nullptr);
/// Into the image itself; the depth stays.
void drawSections(const SectionCurves& curves, const Camera& camera, Image& image);

} // namespace render
