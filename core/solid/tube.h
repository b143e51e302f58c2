// A tube with round ends along a curve through places: as a side, and as surfels (solid/README 3.2).
#pragma once

#include "core/solid/segment_runs.h"
#include "core/solid/side.h"
#include "core/surfel/surfel.h"

#include <span>
#include <vector>

namespace solid {

/// The curve through places as a polyline so fine that it leaves the curve by less than 1/1000 of `radius`: the
/// centripetal one of [Barry88], closed where the last place is the first. Straight from place to place unless
/// `smooth`.
std::vector<base::Vec3d> curveThrough(std::span<const base::Vec3d> places, double radius, bool smooth = true);

/// All that is within a radius of a polyline. Immutable; any number of threads may ask.
class TubeSide : public Side {
  public:
    /// REQUIRES: two places or more.
    TubeSide(std::vector<base::Vec3d> line, double radius);

    SideValue at(const base::Vec3d& x) const override;
    bool meets(const base::Box3d& box) const override;
    SideFoot foot(const base::Vec3d& x) const override;

    std::span<const base::Vec3d> line() const { return m_line; }
    double radius() const { return m_radius; }

  private:
    base::Vec3d nearest(const base::Vec3d& x) const;

    std::vector<base::Vec3d> m_line;
    double m_radius;
    SegmentRuns m_runs;
};

/// Of its surface: about `spacing` apart, none inside another part of the tube, supports by the definition. Throws
/// base::Error where they would be more than 20 million; base::Cancelled by the scope.
surfel::SurfelList surfelsOf(const TubeSide& side, double spacing, const surface::SurfaceDefinition& definition);

} // namespace solid
