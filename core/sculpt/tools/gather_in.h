// Drawing together under the brush: what pinch, crease and blob share.
//
//     D(p) = w(|p - centre| / R) (lift + rate t)        t = (across . (p - centre)) across
//
// across lies in the plane of areaNormal at right angles to the stroke; without a direction t is the whole part of
// p - centre in that plane. Matter is not moved along the stroke, so that its beginning is not drawn thin.
#pragma once

#include "core/sculpt/tools/deform.h"

namespace sculpt {

/// A Field of `deform`.
class GatherIn {
  public:
    /// rate < 0 draws together, > 0 spreads.
    GatherIn(const Brush& brush, const Dab& dab, const base::Vec3f& lift, float rate);
    void operator()(const LanePlace& where, const BrushLanes& at, ShiftLanes& out) const;

  private:
    const Brush& m_brush;
    base::Vec3f m_lift;
    base::Mat3f m_spread; ///< t = m_spread (p - centre), times the rate
};

/// 1 on an open surface, 0 where the middle of the brush lies in a fold that closes: the smallest |m|/w of the surfels
/// there, from 0.75 to 0.95. Drawing together goes no further there.
float foldBrake(const surface::Surface& version, const Dab& dab);

} // namespace sculpt
