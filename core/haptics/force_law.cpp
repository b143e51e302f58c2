#include "core/haptics/force_law.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

/// Mean of the normal at the proxy and at four places around each contact, turned as the contact's.
static Vec3d shadedNormal(const surface::Surface& surface, const Proxy& proxy, double radius) {
    Vec3d sum = proxy.normal();
    for (const Foot& foot : proxy.contacts().feet()) {
        const Vec3d u = base::perpendicular(foot.normal), v = cross(foot.normal, u);
        for (const Vec3d& way : {u, v, -u, -v}) {
            Foot there;
            if (track(surface, foot.position + way * (radius * foot.unit), foot, there) == Tracked::Found)
                sum += there.normal;
        }
    }
    return base::normalized(sum, proxy.normal());
}

Vec3d forceOn(const ForceLaw& law, const Proxy& proxy, const surface::Surface& surface, const Vec3d& x,
              const Vec3d& velocity) {
    if (!proxy.touches())
        return {};
    const Vec3d normal = proxy.normal();
    const Grain grain = grainAt(law.texture, proxy, surface);
    const double depth = proxy.depth(), spring = law.stiffness * depth, felt = std::min(depth, grain.felt);
    const double rough = law.stiffness * felt * (grain.factor - 1);
    const double along = std::max(0.0, spring + rough - law.damping * dot(velocity, normal));
    const Vec3d tangential = (proxy.position() - x) * law.stiffness - normal * spring -
                             grain.slope * (law.stiffness * felt * (depth - felt / 2));
    const Vec3d direction = law.shading > 0 ? shadedNormal(surface, proxy, law.shading) : normal;
    return tangential + direction * along;
}

} // namespace haptics
