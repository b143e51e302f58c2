#include "core/selection/slope.h"

#include "core/base/mat3.h"
#include "core/surface/evaluation/weights.h"

namespace selection {

using base::Vec3d, base::Vec3f;

Vec3d slopeAt(const tree::SurfelTree& tree, int channel, const surfel::SurfelBlock& block, int slot) {
    const Vec3f p = block.position(slot), n = block.normal(slot);
    const float h = block.support(slot);
    const double own = static_cast<double>(valueAt(block, channel, slot));
    base::Mat3d spread;
    Vec3d rise;
    tree.forBlocksInBall(p, h, [&](std::uint32_t, const surfel::SurfelBlock& near) {
        for (int k = 0; k < near.size(); ++k) {
            const float l = distance(near.position(k), p) / h;
            if (l >= 1 || dot(near.normal(k), n) < 0)
                continue;
            // In units of h, so that the sums keep their digits whatever the unit of the model is.
            const Vec3d d = base::cast<double>(near.position(k) - p) / static_cast<double>(h);
            const double w = static_cast<double>(surface::wendlandC2(l));
            spread += base::outer(d, d) * w;
            rise += d * (w * (static_cast<double>(valueAt(near, channel, k)) - own));
        }
    });
    const double ridge = 1e-3 * trace(spread);
    if (!(ridge > 0))
        return {};
    return base::solvePositive(spread + base::Mat3d::identity() * ridge, rise) / static_cast<double>(h);
}

} // namespace selection
