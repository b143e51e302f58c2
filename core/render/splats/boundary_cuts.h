// Where discs end at the boundary of an open surface (render/README 3.1): by a line across the direction away from the
// centroid of a surfel's surroundings, where the off-centre value reaches its limit.
#pragma once

#include "core/render/splats/disc_cuts.h"
#include "core/surface/evaluation/self.h"

namespace render {

/// What cuts are found of, the same for all workers.
struct BoundarySubject {
    /// `radiusOfSupport`: radius of a disc in supports. REQUIRES: the definition has a boundary limit.
    BoundarySubject(const tree::SurfelTree& model, const surface::SurfaceDefinition& definition, float radiusOfSupport);

    surface::Surface plain;   ///< neighbours and weights alone
    surface::Surface fastest; ///< the same as if normals had a common sign
    float radius, limit;
    bool oriented, knowsRims;
};

/// Finds cuts block by block. A worker of one thread, which keeps its memory.
class BoundaryCuts {
  public:
    /// `of` outlives it.
    explicit BoundaryCuts(const BoundarySubject& of) : m_of(of) {}

    /// Cuts those discs of a block that reach the boundary or, unless they are `onSurface` with its normals, stand
    /// across the surface. True if there are any.
    bool cut(const surfel::SurfelBlock& block, CutCodes& codes, bool onSurface = false);

  private:
    CutCode cutOf(const surfel::SurfelBlock& block, int slot, surface::SelfLanes& lanes, bool onSurface) const;

    const BoundarySubject& m_of;
    surface::SelfEvaluator m_self{m_of.fastest};
};

} // namespace render
