// The renderer: a model and a camera in, an image out. Two implementations give the same picture within tolerance:
// tiles on the CPU (cpu_splatter.h) and OpenGL 3.3 (gl_splatter.h) in a context of Qt, OSMesa or EGL. It knows no
// widget.
//
// Splats are blended ([Botsch05], render/README 2.2): nearest layer kept within one splat radius, attributes averaged
// with exp(-2 r^2), shaded once per pixel. Splats of unoriented models face the viewer.
#pragma once

#include "core/render/camera.h"
#include "core/render/effects/effect_table.h"
#include "core/render/effects/ground_grid.h"
#include "core/render/shading/backdrop.h"
#include "core/render/shading/block_colours.h"
#include "core/render/shading/shading_table.h"
#include "core/surface/surface.h"

#include <memory>
#include <optional>
#include <string_view>

namespace render {

struct RenderOptions {
    Shading shading = Shading::Matcap;
    /// What a shading of measured numbers shows (measured_colours.h); blocks that it lacks show their own.
    std::shared_ptr<const BlockColours> colours;
    Backdrop backdrop = Backdrop::Studio;
    bool transparent = false; ///< background with alpha 0
    float splatScale = 1;     ///< times the usual splat radius
    /// Where a node's representatives have discs of at most this radius in pixels, they are drawn instead of its
    /// surfels. About 1 cannot be seen; more is for views that move. 0: every surfel.
    float detailPx = 1;
    /// Splats end where the surface that this defines does, at its boundary limit; without one they are whole discs.
    surface::SurfaceDefinition definition;
    /// All that is drawn is one surface, and all of it: none stands beside it, and no part is hidden.
    bool entire = true;
    bool closed = false; ///< oriented and without an opening: parts that face away need not be drawn
    Effects effects = 0;
    std::optional<GroundGrid> grid;
    /// Pixels for one that a person sees: widths of lines and reaches of effects grow with it.
    float pixelScale = 1;
    bool operator==(const RenderOptions&) const = default;
};

/// Row 0 is the top. Depth is the distance from the eye along the pixel's ray, +inf where nothing is.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint32_t> colour; ///< 0xAABBGGRR (surfel::Colour), not premultiplied
    std::vector<float> depth;
    void resize(int w, int h) {
        width = w, height = h;
        colour.assign(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), 0);
        depth.assign(colour.size(), std::numeric_limits<float>::infinity());
    }
};

class Renderer {
  public:
    virtual ~Renderer() = default;
    virtual const char* name() const = 0;
    /// Draws a version. Implementations keep what the previous version shares with this one.
    virtual void render(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options,
                        Image& out) = 0;
    /// The same picture for less where little has changed. REQUIRES: `out` holds what this renderer's last call of
    /// either drew, untouched.
    virtual void update(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options, Image& out) {
        render(model, camera, options, out);
    }
};

/// Colour of a shaded pixel from blended attributes: the one place both renderers and the ray caster agree on.
/// `normal` in camera coordinates (x right, y up, z towards the eye), unit length.
surfel::Colour shade(Shading shading, const base::Vec3f& normal, surfel::Colour colour, float mask);
} // namespace render
