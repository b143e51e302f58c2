// The last step of every tool that deforms: 16 surfels get their new places, normals and, where footprints follow,
// supports.
//
//     p' = p + d        n' = m / |m|        h' = h sqrt(|m|),    m = cof(F) n: |m| is the stretch of area
//
// Where `turns` is 0 normal and support keep their bits, where d is 0 the place does.
//
// Supports that are ellipsoids are stretched as the surface is, with F itself: the ellipse in the tangent plane goes
// along (surfel/README 2.4), where footprints do not follow with the area that it has.
#pragma once

#include "core/base/mat3.h"
#include "core/surfel/shape.h"

namespace sculpt {

struct MovedLanes {
    alignas(64) float d[3][surfel::clusterSize];  ///< displacement
    alignas(64) float m[3][surfel::clusterSize];  ///< turned normal, of any length
    alignas(64) float turns[surfel::clusterSize]; ///< 1 or 0
};

void move(surfel::SurfelBlock& block, int cluster, const MovedLanes& by, bool footprints);

/// After `move`, of which `before` knows nothing: shapes follow jacobianOf(lane) = F. `shape`: their channel, 0: none.
template <class Jacobian>
void moveShapes(surfel::SurfelBlock& block, const surfel::SurfelBlock& before, int cluster, int shape,
                const MovedLanes& by, bool footprints, const Jacobian& jacobianOf) {
    if (shape == 0)
        return;
    for (int lane = 0; lane < surfel::clusterSize; ++lane) {
        const int slot = cluster * surfel::clusterSize + lane;
        if (by.turns[lane] == 0 || slot >= block.size())
            continue;
        const surfel::Ellipse from{before.support(slot), surfel::shapeOf(before, slot, shape)};
        surfel::Ellipse to = surfel::deformed(from, before.normal(slot), jacobianOf(lane), block.normal(slot));
        if (!footprints)
            to.radius = from.radius * surfel::meanAxis(from.shape) / surfel::meanAxis(to.shape);
        block.channel(cluster, surfel::Support)[lane] = to.radius;
        surfel::setShape(block, slot, shape, to.shape);
    }
}

} // namespace sculpt
