// Pictures with smooth outlines, for files: four splatted pixels make one.
#pragma once

#include "core/render/renderer.h"

#include <functional>

namespace render {

/// Colours are means of 2 x 2 pixels of an image of twice the size (weighted by alpha); depths are those of the
/// pixels' own rays. Costs about five frames.
void renderSmooth(Renderer& renderer, const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options,
                  Image& out);
/// The same for any way to draw.
void renderSmooth(const Camera& camera, const std::function<void(const Camera&, Image&)>& draw, Image& out);
/// Colours alone: means of 2 x 2 pixels. REQUIRES: `fine` is twice as wide and as high as `out`.
void shrink(const Image& fine, Image& out);

} // namespace render
