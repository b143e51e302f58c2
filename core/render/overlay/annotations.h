// What stands over a picture: the legend of a colour scale, a scale bar, the axes. A list of lines, letters and ramps
// in pixels, worked out here and drawn by whoever has a surface to draw on: onto an Image without fonts or a display
// (annotation_canvas.h), or by the window's painter.
#pragma once

#include "core/render/camera.h"
#include "core/render/overlay/pen.h"
#include "core/render/shading/backdrop.h"
#include "core/render/shading/colour_map.h"

#include <optional>

namespace render {

/// A set of them; 0: none.
using Annotated = std::uint32_t;
enum Annotation : Annotated { Legend = 1, ScaleBar = 2, Axes = 4 };

struct AnnotationRow {
    Annotation annotation;
    const char* id; ///< "scale-bar"
    const char* label;
    const char* tip;
};
std::span<const AnnotationRow> annotationTable();

struct DrawnLine {
    ImagePoint from, to;
    float width = 1;
    base::Vec3f colour; ///< sRGB, 0 to 1
};
struct DrawnText {
    ImagePoint at;        ///< on the base line
    float anchor = 0;     ///< 0: begins at `at`, 1: ends there
    float capHeight = 10; ///< pixels
    std::string text;
    base::Vec3f colour;
};
/// The colours of a map, the highest number on top.
struct DrawnRamp {
    ImagePoint corner; ///< upper left
    float width = 0, height = 0;
    ColourMap map = ColourMap::Diverging;
};
struct Drawing {
    std::vector<DrawnLine> lines;
    std::vector<DrawnText> texts;
    std::vector<DrawnRamp> ramps;
};

/// `scale`: of the legend; without one there is none. The scale bar is true at the depth of the camera's target, in
/// model units; with parallel rays everywhere. `pixelScale`: pixels for one that a person sees.
Drawing annotate(Annotated wanted, const Camera& camera, const std::optional<ColourScale>& scale, Backdrop backdrop,
                 float pixelScale = 1);

} // namespace render
