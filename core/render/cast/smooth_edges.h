// Antialiasing of cast pictures: eight more rays for pixels that differ from a neighbour, none for the others.
#pragma once

#include "core/render/cast/lit_layer.h"
#include "core/render/shading/measured_colours.h"

namespace render {

/// What the pixels' own rays were shown by, and the additional ones are.
struct EdgeLook {
    Shading shading = Shading::Matcap;
    const Measured* measured = nullptr;
    const raycast::LightScene* light = nullptr; ///< none: as shaded
};

struct EdgeCounts {
    std::size_t rays = 0, evaluations = 0;
    raycast::LightCounts light;
};

/// Colours of pixels that stand out from one beside, above or below become means over the pixel: its own ray and
/// eight more, in no line with each other. Depths and normals stay those of the pixels' own rays. In parallel; the same
/// bits at any thread count. Throws base::Cancelled.
void smoothEdges(const surface::Surface& surface, const Camera& camera, const EdgeLook& look, ShadedLayer& layer,
                 EdgeCounts& counts, const base::Progress& progress);

} // namespace render
