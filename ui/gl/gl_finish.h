// The fourth pass of the GL picture, where effects or the grid are wanted: the formulas of screen_effects.h and
// ground_grid.h as a shader over what pass 3 shaded. Built when first used.
#pragma once

#include "core/render/effects/ground_grid.h"
#include "core/render/effects/screen_effects.h"
#include "core/render/renderer.h"
#include "ui/gl/gl_program.h"
#include "ui/gl/gl_targets.h"

#include <memory>

namespace render {

std::string finishFragmentShader();
/// Its part that is the effects: a function vec3 withEffects(rgb, geometry, ray, 1 / unit).
std::string effectShader();

class GlFinish {
  public:
    explicit GlFinish(const GlFunctions& gl) : m_gl(gl) {}
    static bool wanted(const RenderOptions& options) { return options.effects || options.grid; }
    /// From targets.shaded() into the bound framebuffer's first attachment, with the bound vertex array.
    void draw(GlTargets& targets, const ViewFrame& view, const Camera& camera, const RenderOptions& options);

  private:
    void setTaps(const EffectRow& row, const EffectTaps& taps) const;
    void setGrid(const GridPlan& plan) const;

    const GlFunctions& m_gl;
    std::unique_ptr<GlProgram> m_program;
};

} // namespace render
