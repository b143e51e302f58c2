// The GL splatter with a context of its own, without a window: what `--backend osmesa` and `--backend egl` draw with.
//
// The context is current only inside `render`, so that it can live beside others on the thread.
#pragma once

#include "ui/gl/gl_context.h"
#include "ui/gl/gl_splatter.h"

namespace render {

class OffscreenRenderer : public Renderer {
  public:
    explicit OffscreenRenderer(std::unique_ptr<GlContext> context);
    ~OffscreenRenderer() override;
    const char* name() const override { return m_context->name(); }
    void render(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options, Image& out) override;

    const GlSplatter& splatter() const { return *m_splatter; }
    void limitPointSize(float pixels) { m_splatter->limitPointSize(pixels); }

  private:
    std::unique_ptr<GlContext> m_context;
    std::unique_ptr<GlSplatter> m_splatter;
};

} // namespace render
