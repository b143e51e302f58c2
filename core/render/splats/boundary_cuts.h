// Where discs end at the boundary of an open surface (render/README 3.1): by a line across the direction away from the
// centroid of a surfel's surroundings, where the off-centre value reaches its limit.
#pragma once

#include "core/render/splats/disc_cuts.h"
#include "core/surface/evaluation/self.h"

namespace render {

/// Finds cuts block by block. A worker of one thread, which keeps its memory.
class BoundaryCuts {
  public:
    /// `radiusOfSupport`: radius of a disc in supports. REQUIRES: the definition has a boundary limit.
    BoundaryCuts(const tree::SurfelTree& model, const surface::SurfaceDefinition& definition, float radiusOfSupport);

    /// Cuts those discs of a block that reach the boundary or stand across the surface. True if there are any.
    bool cut(const surfel::SurfelBlock& block, CutCodes& codes);

  private:
    CutCode cutOf(const surfel::SurfelBlock& block, int slot, surface::SelfLanes& lanes) const;

    surface::Surface m_surface, m_quick;
    float m_radius, m_limit;
    bool m_oriented;
    surface::SelfEvaluator m_self{m_quick};
};

} // namespace render
