// The renderer for machines without a usable GPU: blended splats by tiles on all cores, straight into an image.
//
//     walk the tree (visible_blocks) -> bins of clusters per tile (tile_bins)
//     -> per tile, in parallel: gather, visibility, attributes (splat_kernels), shade (shading)
//
// A frame costs what is visible: blocks outside the view are skipped by the walk, small nodes answer with their
// representatives, hidden clusters are skipped by the tile, front to back. `update` from the same place costs what has
// changed: versions share the blocks that an edit leaves alone, and only tiles that a new or a gone block can touch are
// drawn again, to the same bits as the whole picture. Same bits at any thread count.
#pragma once

#include "core/render/effects/finish.h"
#include "core/render/renderer.h"
#include "core/render/shaded_layer.h"
#include "core/render/splats/splat_kernels.h"

#include <optional>

namespace render {

class CpuSplatter : public Renderer {
  public:
    const char* name() const override { return "cpu"; }
    void render(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options, Image& out) override;
    void update(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options, Image& out) override;

    /// From now on pixels that the layer knows are taken from it, and only the others are drawn; null: all are drawn.
    /// A layer of another size than the picture's counts as none. It is not changed any more.
    void showOver(std::shared_ptr<const ShadedLayer> layer) { m_layer = std::move(layer); }

    const DetailCache& details() const { return m_details; }

  private:
    /// What the last picture was drawn with, apart from the model.
    struct Setting {
        Camera camera;
        RenderOptions options;
        SplatStyle style;
        bool operator==(const Setting&) const = default;
        /// Both with a table of colours, or both without.
        bool sameButColours(const Setting& o) const;
    };
    Sight sight(const tree::SurfelTree& model, const ViewFrame& view, const Setting& setting);
    void addRecolouredTiles(const std::shared_ptr<const BlockColours>& from,
                            const std::shared_ptr<const BlockColours>& to, const tree::SurfelTree& model,
                            const Sight& seen, TileMask& mask);
    void addRelayeredTiles(const ViewFrame& view, const ShadedLayer* wanted, TileMask& mask);
    void drawTiles(const Setting& setting, std::span<const std::uint32_t> tiles, Image& out);

    std::optional<Setting> m_setting;
    tree::SurfelTree m_model; ///< of the last picture
    DetailCache m_details;
    DiscCuts m_discCuts;
    FinerBlocks m_finer;
    std::vector<VisibleBlock> m_visible; ///< that the tiles to be drawn are binned from
    TileBins m_bins;
    Finish m_finish;                                          ///< of the picture; its options are the setting's
    std::shared_ptr<const ShadedLayer> m_layer, m_drawnLayer; ///< wanted; in the picture
};

} // namespace render
