// What is drawn instead of blocks whose discs are large in the image and stand out over the surface, as those of few
// samples do where it bends: for each surfel seven discs and more, on the surface itself (render/README 4.4);
// and instead of those whose surfels lie off the surface, as those of raw scans: the same discs on it (4.5).
// The other way from node_detail.h, where one disc stands for many.
//
// Neighbours decide where the surface is, so that an edit changes the finer discs of blocks that it leaves alone:
// `follow` drops them. Memory: seven times the blocks that a picture asked for, more where discs are
// larger than 10 pixels. One thread at a time.
#pragma once

#include "core/render/renderer.h"
#include "core/render/splats/finer_discs.h"

namespace render {

class FinerBlocks {
  public:
    /// Seven discs for up to 128, in blocks; null: their discs are whole.
    struct Part {
        surfel::BlockPtr block;
        std::unique_ptr<CutCodes> cuts;
    };

    /// What is to stand for a block.
    struct Wish {
        const surfel::SurfelBlock* block;
        bool spread;                   ///< seven discs for one; else one, where the surface is
        bool cut;                      ///< where the surface ends; those that are spread always are
        float pixel = 0;               ///< how long one is there: as finely as can be seen (FinerWay)
        const CutCodes* own = nullptr; ///< where its discs are cut; null: nowhere
    };

    /// Whether splats may be drawn finer than they are: of a surface, smooth or with cells, in a view that rests.
    static bool any(const tree::SurfelTree& model, const RenderOptions& options);
    /// What finer discs depend on beside the version; forgets all if it changes.
    void use(const surface::SurfaceDefinition& definition, float radiusOfSupport);
    /// Whether the surface may end somewhere.
    bool bounded() const { return std::isfinite(m_definition.boundaryLimit); }
    /// How far the discs of these blocks stand out over the surface, in model units, in their order.
    std::vector<float> standOut(std::span<const surfel::SurfelBlock* const> blocks);
    /// How far their surfels lie off it; 0 for models with cells, whose edges would fray.
    std::vector<float> offSurface(std::span<const surfel::SurfelBlock* const> blocks);
    /// Makes what is wished for and not there yet, of blocks of the version followed to, on all cores.
    void prepare(std::span<const Wish> wishes);
    /// Of a block that was prepared.
    std::span<const Part> of(const surfel::SurfelBlock* block) const { return m_kept.at(block).parts; }
    /// Goes on to the next version. Returns the blocks that it shares with the last whose finer discs it dropped.
    std::vector<const surfel::SurfelBlock*> follow(const tree::SurfelTree& to);
    /// Finer blocks dropped since the last call: whoever holds copies of them may drop those too.
    std::vector<surfel::BlockPtr> takeDropped() { return std::exchange(m_dropped, {}); }

  private:
    struct Kept {
        surfel::BlockPtr block;               ///< keeps its address its own
        float standOut = -1, offSurface = -1; ///< not known yet
        bool spread = false, cut = false;     ///< what the parts are
        float pixel = 0;
        std::vector<Part> parts;
    };
    void drop(Kept& kept);
    Kept& keptOf(const surfel::SurfelBlock& block);
    /// Of each block, what `value` keeps, or `measure` finds.
    template <class Measure>
    std::vector<float> measured(std::span<const surfel::SurfelBlock* const> blocks, float Kept::*value,
                                const Measure& measure);

    surface::SurfaceDefinition m_definition;
    float m_radiusOfSupport = 0;
    tree::SurfelTree m_model;
    std::unordered_map<const surfel::SurfelBlock*, Kept> m_kept;
    std::vector<surfel::BlockPtr> m_dropped;
};

} // namespace render
