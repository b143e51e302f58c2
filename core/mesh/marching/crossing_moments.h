// How flat the surface is where it crosses some edges: sums that add up from cube to cube. Internal to the room.
#pragma once

#include "core/base/mat3.h"
#include "core/mesh/marching/edge_walk.h"

#include <algorithm>

namespace mesh {

/// Sums over the crossings in a cube, relative to the first of them.
struct CrossingMoments {
    double count = 0;
    base::Vec3d about; ///< the first crossing's position
    base::Vec3d sum;
    base::Mat3d squares, normals;

    void add(const Crossing& c) {
        if (count == 0)
            about = c.position;
        const base::Vec3d p = c.position - about, n = base::cast<double>(c.normal);
        count += 1;
        sum += p;
        squares += base::outer(p, p);
        normals += base::outer(n, n);
    }
    void add(const CrossingMoments& o) {
        if (o.count == 0)
            return;
        if (count == 0)
            about = o.about;
        const base::Vec3d d = o.about - about;
        squares += o.squares + base::outer(d, o.sum) + base::outer(o.sum, d) + base::outer(d, d) * o.count;
        sum += o.sum + d * o.count;
        normals += o.normals;
        count += o.count;
    }
    /// Variance of the heights over the best plane.
    double roughness() const {
        const base::Mat3d covariance = squares * (1 / count) + base::outer(sum, sum) * (-1 / (count * count));
        return std::max(0.0, base::symmetricEigen(covariance).value[0]);
    }
    /// 1 where all normals are parallel.
    double likeness() const { return base::symmetricEigen(normals).value[2] / count; }
};

} // namespace mesh
