// Pictures of several models beside each other: each drawn as if it were alone, then put together by depth, so that
// each keeps its own definition, scale of splats and rays. Light does not pass between them: shadows and occlusion are
// each model's own.
#pragma once

#include "core/render/picture.h"

namespace render {

/// Draws from any number of views. One thread at a time.
class ScenePictureMaker {
  public:
    /// In the same coordinates. The first is the one that the options' reference, attribute and legend belong to.
    ScenePictureMaker(const std::vector<surface::Surface>& models, const PictureOptions& options);

    /// As PictureMaker; of one model the same picture.
    Image draw(const Camera& camera, PictureStats& stats, const base::Progress& progress);

  private:
    PictureOptions m_options;
    std::vector<std::unique_ptr<PictureMaker>> m_makers;
    std::unique_ptr<PictureMaker> m_backdrop; ///< of several models: what is behind them
};

/// `other` put into `into`: per pixel the nearer one in front, with alpha. Both of one size.
void mergeByDepth(Image& into, const Image& other);

} // namespace render
