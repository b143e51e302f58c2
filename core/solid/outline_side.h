// The solid behind an outline that is drawn in a picture: all that the picture's rays sweep, a prism where they are
// parallel, else a cone about the eye (solid/README 3.1). What the outline goes round twice is outside.
//
// Model coordinates, float64. Immutable; any number of threads may ask, in a time that hardly grows with the corners.
#pragma once

#include "core/base/outline.h"
#include "core/solid/segment_runs.h"
#include "core/solid/side.h"

namespace solid {

/// Where a picture is seen from. Axes are unit and at right angles to each other.
struct PictureFrame {
    base::Vec3d eye, forward, right, upright;
    bool parallel = false;

    /// A place of the picture (in model units along right and upright, in perspective at depth 1) at a depth.
    base::Vec3d place(const base::Point2& p, double depth) const {
        const double scale = parallel ? 1 : depth;
        return eye + forward * depth + right * (p.x * scale) + upright * (p.y * scale);
    }
    /// Of a place: where it is in the picture, and how deep.
    base::Point2 seen(const base::Vec3d& x) const;
    double depth(const base::Vec3d& x) const { return dot(x - eye, forward); }
    /// Model units per unit of the picture.
    double scale(double depth) const { return parallel ? 1 : depth; }
};

class OutlineSide : public Side {
  public:
    /// REQUIRES: three corners or more, the last one is joined to the first.
    OutlineSide(const PictureFrame& frame, std::vector<base::Point2> corners);

    SideValue at(const base::Vec3d& x) const override;
    bool meets(const base::Box3d& box) const override;
    SideFoot foot(const base::Vec3d& x) const override;

    /// Does the outline hold what is seen there?
    bool holds(const base::Vec3d& x) const;
    const PictureFrame& frame() const { return m_frame; }
    std::span<const base::Point2> corners() const { return m_corners; }

  private:
    /// From the ray of one corner to that of the next: with parallel rays places at depth 0, else directions; both from
    /// the eye.
    struct Wall {
        base::Vec3d from, to;
        base::Vec3d normal; ///< unit, of a sector's plane; zero where it has none
    };
    std::vector<Wall> wallsOf() const;
    SegmentRuns runsOf() const;
    base::Vec3d onWall(const Wall& wall, const base::Vec3d& fromEye) const;
    std::size_t nearestWall(const base::Vec3d& fromEye) const;

    PictureFrame m_frame;
    std::vector<base::Point2> m_corners;
    base::Outline m_outline;
    std::vector<Wall> m_walls;
    SegmentRuns m_runs;
};

} // namespace solid
