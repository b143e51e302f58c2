#include "core/selection/regions.h"

namespace selection {

using base::Box3d, base::Vec3d;

/// Boxes are taken a little larger than they are against rounding: a box that is Partly is looked into.
constexpr double slack = 1e-12;

Relation BallRegion::relation(const Box3d& box) const {
    const double size = slack * (radius + length(centre) + length(box.lo) + length(box.hi));
    if (box.distanceSq(centre) > (radius + size) * (radius + size))
        return Relation::Outside;
    const Vec3d far{std::max(std::abs(box.lo.x - centre.x), std::abs(box.hi.x - centre.x)),
                    std::max(std::abs(box.lo.y - centre.y), std::abs(box.hi.y - centre.y)),
                    std::max(std::abs(box.lo.z - centre.z), std::abs(box.hi.z - centre.z))};
    return length(far) + size < radius ? Relation::Inside : Relation::Partly;
}

Relation BoxRegion::relation(const Box3d& other) const {
    if (!box.overlaps(other))
        return Relation::Outside;
    return box.contains(other.lo) && box.contains(other.hi) ? Relation::Inside : Relation::Partly;
}

Relation PlaneRegion::relation(const Box3d& box) const {
    const Vec3d centre = (box.lo + box.hi) * 0.5, halves = (box.hi - box.lo) * 0.5;
    const Vec3d& n = plane.normal;
    const double reach = std::abs(n.x) * halves.x + std::abs(n.y) * halves.y + std::abs(n.z) * halves.z;
    const double height = plane.distance(centre), size = slack * (length(centre) + reach + std::abs(plane.offset));
    if (height > reach + size)
        return Relation::Inside;
    return height < -reach - size ? Relation::Outside : Relation::Partly;
}

} // namespace selection
