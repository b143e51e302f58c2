// Blended splats by OpenGL 3.3, in three passes ([Botsch05], render/README 2.2), into any framebuffer of the current
// context. The same picture as the CPU splatter's within a mean difference of 1/255.
//
//     pass 1  depth alone: how far behind the nearest splat others still belong to its layer
//     pass 2  normals, colours, masks and depths of that layer, added up with weights, into half floats
//     pass 3  one triangle: normalise, shade once per pixel, background
//
// A window makes its context current, builds one from its own getProcAddress, and calls drawTo when it paints:
//
//     splatter = std::make_unique<GlSplatter>(getProcAddress);                     // initializeGL
//     splatter->drawTo(defaultFramebufferObject(), tree, camera, options);         // paintGL
//     splatter.reset();                                                            // before the context goes
//
// One thread; the same context must be current in every call, the destructor included.
#pragma once

#include "core/render/renderer.h"
#include "core/render/splats/splat_style.h"
#include "core/render/splats/visible_blocks.h"
#include "ui/gl/gl_finish.h"
#include "ui/gl/gl_program.h"
#include "ui/gl/gl_shaders.h"
#include "ui/gl/gl_slots.h"
#include "ui/gl/gl_targets.h"

#include <array>

namespace render {

class GlSplatter {
  public:
    /// Throws base::Error where the context is older than 3.3 or lacks something.
    explicit GlSplatter(const GetProcAddress& address);
    ~GlSplatter();
    GlSplatter(const GlSplatter&) = delete;
    GlSplatter& operator=(const GlSplatter&) = delete;

    /// Draws into the lower left camera.width x camera.height pixels of a framebuffer. Leaves GL's state as a fresh
    /// context has it, but for bindings.
    void drawTo(GLuint framebuffer, const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options);
    /// Draws into its own framebuffer and reads colour and depth back.
    void drawTo(Image& out, const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options);

    const GlSlots& storage() const { return m_slots; }
    const DetailCache& details() const { return m_details; }
    /// Largest point sprite used; splats that may be larger become quads. For tests.
    void limitPointSize(float pixels) { m_maxPointSize = std::min(m_maxPointSize, pixels); }

  private:
    struct Frame;
    void splats(const Frame& frame);
    void drawPass(const Frame& frame, SplatPass pass);
    void shade(const Frame& frame, const Camera& camera, GLuint framebuffer, bool depth);
    void setView(const GlProgram& program, const Frame& frame) const;
    void bindAttributes(std::size_t page, GLint firstSurfel, GLuint divisor) const;
    void look(const tree::SurfelTree& model, const Frame& frame);
    const GlProgram& program(SplatShape shape, SplatPass pass) const {
        return *m_programs[static_cast<std::size_t>(shape) * 2 + static_cast<std::size_t>(pass)];
    }

    GlFunctions m_gl;
    GlSlots m_slots;
    GlTargets m_targets;
    std::array<std::unique_ptr<GlProgram>, 4> m_programs; ///< shape * 2 + pass
    GlProgram m_shade;
    GlFinish m_finish;
    GLuint m_vertexArray = 0;
    float m_maxPointSize = 1;
    DetailCache m_details;
    DiscCuts m_discCuts;
    FinerBlocks m_finer;
    tree::SurfelTree m_shown; ///< that m_details belong to
    std::vector<VisibleBlock> m_visible;
    struct Points {
        std::vector<GLint> firsts;
        std::vector<GLsizei> counts;
    };
    std::vector<Points> m_points;                    ///< of each page, the blocks drawn as points
    std::vector<const surfel::SurfelBlock*> m_large; ///< blocks drawn as quads
};

} // namespace render
