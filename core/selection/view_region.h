// What an outline in a picture holds: all that the camera sees behind it, through everything, or of that only what is
// visible, by the exact surface (selection/README 3).
#pragma once

#include "core/base/outline.h"
#include "core/render/camera.h"
#include "core/selection/regions.h"
#include "core/surface/surface.h"

namespace selection {

struct ViewRegion {
    render::Camera camera;
    base::Outline outline; ///< in pixels; (0, 0) is the picture's upper left corner
    /// Depths along `forward` from the eye's plane between which surfels count.
    double nearest = 0, farthest = std::numeric_limits<double>::infinity();

    ViewRegion(const render::Camera& camera, base::Outline outline);
    bool holds(const base::Vec3d& x) const;
    Relation relation(const base::Box3d& box) const;

  private:
    base::Vec3d place(const base::Vec3d& x) const; ///< as Camera::project
    base::Vec3d m_forward, m_right, m_upright;
    double m_focal;
};

/// Of what was found, the surfels that the camera sees: a ray to the surfel meets no surface before it,
/// where what is hidden is in no way. The first hit
/// may lie before a surfel that faces the eye by less than its support: noise stands off the surface.
/// In parallel, a ray a surfel.
tree::Selection visibleOf(const surface::Surface& surface, const render::Camera& camera, const tree::Selection& found);

} // namespace selection
