// Segments and the surface: many single ones, one after the other, as a mesher asks for them. The same roots as those
// of intersect.h by its fast policy, without what a call per ray costs.
//
// Where an end lies on the surface to rounding, f at that end decides which side it is on: the same for all segments
// that end there, so that segments which follow each other through the surface meet it once.
//
// Used by one thread at a time. A segment gives the same bits whatever was asked before, and the same from either end.
#pragma once

#include "core/surface/intersect.h"

#include <memory>
#include <optional>

namespace surface {

class SegmentCaster {
  public:
    /// REQUIRES: `surface` outlives the caster.
    explicit SegmentCaster(const Surface& surface);
    ~SegmentCaster();

    /// A place where the segment meets the surface, exactly on the segment and within float's precision of the root;
    /// the first one seen from the lower end, coordinate by coordinate.
    std::optional<base::Vec3d> meet(const base::Vec3d& a, const base::Vec3d& b) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace surface
