// The finer discs of a block's (render/README 4.4, 4.5), on the surface: where there is a foot for each, or where seven
// feet tell how the surface lies about a surfel (smooth_patch.h). What rays would pass has none.
//
// Lengths are in model units. A worker of one thread.
#pragma once

#include "core/render/splats/disc_cuts.h"
#include "core/render/splats/finer_in_cells.h"
#include "core/render/splats/smooth_patch.h"
#include "core/render/splats/spread_discs.h"
#include "core/surface/projection/project.h"

namespace render {

/// How far discs that are spread reach from the surfels that they stand for, and any of them, in radii of those.
constexpr float spreadReach = 1.4f, finerReach = 2.4f;

/// What is drawn: a disc, or an ellipse.
struct FinerDisc {
    surfel::Surfel surfel;
    base::Vec3f shape;
    CutCode code = wholeDisc;
};

/// How finely discs are made.
struct FinerWay {
    /// How long one is there: as finely as can be seen. 0: seven for each.
    float pixel = 0;
    const CutCodes* ends = nullptr; ///< not null: the surface ends within those that are cut
};

class FinerDiscs {
  public:
    /// `cells`: null for models without; like `surface` it outlives it.
    FinerDiscs(const surface::Surface& surface, const cells::CellSurface* cells, float radiusOfSupport);

    /// All of a block, surfel by surfel; of models with cells always seven for each. Where the surface has no foot it
    /// is looked for half a step farther in; a surfel that has none at all stays as it is.
    std::vector<FinerDisc> of(const surfel::SurfelBlock& block, const FinerWay& way);
    /// One disc for each surfel, at its foot; without one it stays where it is. REQUIRES: no cells.
    std::vector<FinerDisc> settled(const surfel::SurfelBlock& block) const;

  private:
    using Feet = std::span<const surface::Projection<float>>;
    struct Plan {
        int rings = 1;
        bool ends = false;
        bool loose = false; ///< few others are near, and surface may go on to them from where its own disc ends
    };
    /// Places of finer discs in the planes of their surfels, slot by slot, and their feet.
    struct Spread {
        std::vector<base::Vec3f> inPlane;
        std::vector<surface::Projection<float>> feet;
        std::array<std::size_t, surfel::blockCapacity + 1> first{};

        Feet feetOf(int i) const {
            const auto slot = static_cast<std::size_t>(i);
            return std::span(feet).subspan(first[slot], first[slot + 1] - first[slot]);
        }
    };

    FinerDisc discOf(const surfel::SurfelBlock& block, int i) const;
    float radiusOf(const surfel::SurfelBlock& block, int i) const { return m_radius * block.support(i); }
    /// By the plan of each slot; none where there is no plan.
    Spread footed(const surfel::SurfelBlock& block, std::span<const std::optional<Plan>> plans) const;
    Plan planOf(const surfel::SurfelBlock& block, int i, Feet seven, const FinerWay& way) const;
    bool isSettled(const surfel::SurfelBlock& block, int i, const surface::Projection<float>& foot) const;
    std::optional<SmoothPatch> patchOf(const surfel::SurfelBlock& block, int i, Feet found, float most) const;
    bool isOn(const base::Vec3f& x, float most) const;
    void addSmooth(const surfel::SurfelBlock& block, int i, const Plan& plan, const SmoothPatch& patch, float most,
                   std::vector<FinerDisc>& out) const;
    void addFooted(const surfel::SurfelBlock& block, int i, int rings, const Spread& spread,
                   std::vector<FinerDisc>& out);
    bool settle(FinerDisc& disc, const surfel::SurfelBlock& block, int i, bool ends,
                const surface::Projection<float>* foot);

    const surface::Surface& m_surface;
    float m_radius;
    int m_shape;
    const cells::LabelLayout* m_labels; ///< null for models without cells
    std::optional<FinerInCells> m_cells;
};

} // namespace render
