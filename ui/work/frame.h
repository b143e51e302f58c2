// One picture asked of a viewport, and what it tells of a picture of the true surface. Plain values: the interface's
// thread makes frames, the drawing thread reads them.
#pragma once

#include "core/raycast/lighting.h"
#include "core/render/renderer.h"
#include "core/render/shading/measured_colours.h"

#include <memory>
#include <optional>

namespace ui {

/// The surface itself, to be shown instead of splats as soon as rays have found it.
struct TrueSurface {
    surface::Surface surface; ///< of the frame's model
    double quality = 1;       ///< in pixels (adaptive_cast.h)
    raycast::Lighting lighting;
    std::shared_ptr<const render::Measured> measured; ///< what the shading measures, if it does
};

/// How far a picture of the true surface has come.
struct Refinement {
    double quality = 0; ///< reached, in pixels
    bool complete = false;
    double seconds = 0; ///< since the view came to rest
    double light = 0;   ///< share of the light found, 0 to 1; light comes last, after the surface
};

struct Frame {
    tree::SurfelTree model;
    render::Camera camera; ///< its size is the viewport's in device pixels
    render::RenderOptions options;
    bool moving = false;              ///< more follow at once: speed before quality
    std::optional<TrueSurface> truth; ///< without it, splats
    bool smooth = false;              ///< at rest, outlines are to be smooth
    std::uint64_t input = 0;          ///< the last pointer event that it shows, as PointerRouter counts them
};

} // namespace ui
