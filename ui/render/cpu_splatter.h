// The renderer for machines without a usable GPU: blended splats by tiles on all cores, straight into an image.
//
//     walk the tree (visible_blocks) -> bins of clusters per tile (tile_bins)
//     -> per tile, in parallel: gather, visibility, attributes (splat_kernels), shade (shading)
//
// A frame costs what is visible: blocks outside the view are skipped by the walk, hidden clusters by the tile, front to
// back. Nothing is kept between versions but memory. Same bits at any thread count.
#pragma once

#include "ui/render/renderer.h"
#include "ui/render/splat_kernels.h"

namespace render {

class CpuSplatter : public Renderer {
  public:
    const char* name() const override { return "cpu"; }
    void render(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options, Image& out) override;

  private:
    std::vector<VisibleBlock> m_visible;
    TileBins m_bins;
};

} // namespace render
