#include "ui/gl/offscreen_renderer.h"

namespace render {

OffscreenRenderer::OffscreenRenderer(std::unique_ptr<GlContext> context) : m_context(std::move(context)) {
    const Current current(*m_context);
    m_splatter = std::make_unique<GlSplatter>([this](const char* name) { return m_context->procAddress(name); });
}

OffscreenRenderer::~OffscreenRenderer() {
    const Current current(*m_context);
    m_splatter.reset();
}

void OffscreenRenderer::render(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options,
                               Image& out) {
    const Current current(*m_context);
    m_splatter->drawTo(out, model, camera, options);
}

} // namespace render
