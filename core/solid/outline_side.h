// The solid behind an outline that is drawn in a picture: all that the picture's rays sweep, a prism where they are
// parallel, else a cone about the eye (solid/README 3.1). What the outline goes round twice is outside.
//
// Model coordinates, float64. Immutable; any number of threads may ask.
#pragma once

#include "core/solid/side.h"

#include <array>
#include <span>
#include <vector>

namespace solid {

/// Where a picture is seen from. Axes are unit and at right angles to each other.
struct PictureFrame {
    base::Vec3d eye, forward, right, upright;
    bool parallel = false;

    /// A place of the picture (in model units along right and upright, in perspective at depth 1) at a depth.
    base::Vec3d place(double u, double v, double depth) const {
        const double scale = parallel ? 1 : depth;
        return eye + forward * depth + right * (u * scale) + upright * (v * scale);
    }
    /// Of a place: u, v and depth.
    base::Vec3d seen(const base::Vec3d& x) const;
    /// Model units per unit of the picture.
    double scale(double depth) const { return parallel ? 1 : depth; }
};

using PicturePoint = std::array<double, 2>;

class OutlineSide : public Side {
  public:
    /// REQUIRES: three corners or more, the last one is joined to the first.
    OutlineSide(const PictureFrame& frame, std::vector<PicturePoint> corners);

    SideValue at(const base::Vec3d& x) const override;
    bool meets(const base::Box3d& box) const override;
    SideFoot foot(const base::Vec3d& x) const override;

    bool holds(const PicturePoint& p) const;
    const PictureFrame& frame() const { return m_frame; }
    std::span<const PicturePoint> corners() const { return m_corners; }

  private:
    base::Vec3d wallFoot(std::size_t wall, const base::Vec3d& x) const;

    PictureFrame m_frame;
    std::vector<PicturePoint> m_corners;
};

} // namespace solid
