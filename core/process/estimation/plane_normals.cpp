// Normals of planes, of several positions side by side in lanes: square roots and quotients are what they cost. Every
// position's sums are taken in the order of its neighbours, so that the lanes do not show in the bits.
#include "core/base/clones.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/least_direction.h"

#include <algorithm>
#include <cmath>

namespace process {

constexpr std::size_t lanes = 8;
/// Reach of the weight over the distance of the farthest neighbour: beyond 1, so that the farthest counts too.
constexpr double reachOverFarthest = 1.4;

namespace {

/// From each lane's position to its k-th neighbour.
struct Ways {
    float x[lanes], y[lanes], z[lanes], distanceSq[lanes];
};

/// Weights, weighted ways and their products.
struct Sums {
    double w[lanes], x[lanes], y[lanes], z[lanes];
    double xx[lanes], xy[lanes], xz[lanes], yy[lanes], yz[lanes], zz[lanes];
};

/// Least direction of the Wendland-weighted covariance about the weighted mean (process/README 2.1), relative to the
/// position itself.
base::Vec3f normalOf(const Sums& s, std::size_t l) {
    const double w = s.w[l];
    const base::Vec3d m{s.x[l] / w, s.y[l] / w, s.z[l] / w};
    base::Mat3d c;
    c[0][0] = s.xx[l] - w * m.x * m.x;
    c[0][1] = c[1][0] = s.xy[l] - w * m.x * m.y;
    c[0][2] = c[2][0] = s.xz[l] - w * m.x * m.z;
    c[1][1] = s.yy[l] - w * m.y * m.y;
    c[1][2] = c[2][1] = s.yz[l] - w * m.y * m.z;
    c[2][2] = s.zz[l] - w * m.z * m.z;
    return base::normalized(base::cast<float>(leastDirection(c)), {0, 0, 1});
}

} // namespace

POINTCLAY_CLONES
static void addUp(const Ways* ways, std::size_t count, Sums& s) {
    double reachSq[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
        reachSq[l] = reachOverFarthest * reachOverFarthest * static_cast<double>(ways[count - 1].distanceSq[l]);
        s.w[l] = 1; // the position itself: weight 1 at 0
        s.x[l] = s.y[l] = s.z[l] = s.xx[l] = s.xy[l] = s.xz[l] = s.yy[l] = s.yz[l] = s.zz[l] = 0;
    }
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t l = 0; l < lanes; ++l) {
            const double qx = static_cast<double>(ways[k].x[l]), qy = static_cast<double>(ways[k].y[l]),
                         qz = static_cast<double>(ways[k].z[l]);
            const double r = std::sqrt(static_cast<double>(ways[k].distanceSq[l]) / reachSq[l]), u = 1 - r;
            const double weight = u * u * u * u * (4 * r + 1);
            const double vx = qx * weight, vy = qy * weight, vz = qz * weight;
            s.w[l] += weight;
            s.x[l] += vx, s.y[l] += vy, s.z[l] += vz;
            s.xx[l] += vx * qx, s.xy[l] += vx * qy, s.xz[l] += vx * qz;
            s.yy[l] += vy * qy, s.yz[l] += vy * qz, s.zz[l] += vz * qz;
        }
}

void planeNormals(std::span<const base::Vec3f> positions, const NearestRows& rows, std::size_t k, base::Vec3f* out) {
    std::vector<Ways> ways(k);
    Sums sums;
    for (std::size_t first = 0; first < rows.count; first += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) {
            const std::size_t row = std::min(first + l, rows.count - 1); // spare lanes do the last one again
            const base::Vec3f& p = positions[rows.first + row];
            for (std::size_t n = 0; n < k; ++n) {
                const base::Vec3f way = positions[rows.index[row * rows.k + n]] - p;
                ways[n].x[l] = way.x, ways[n].y[l] = way.y, ways[n].z[l] = way.z;
                ways[n].distanceSq[l] = rows.distanceSq[row * rows.k + n];
            }
        }
        addUp(ways.data(), k, sums);
        for (std::size_t l = 0; l < std::min(lanes, rows.count - first); ++l)
            out[first + l] = normalOf(sums, l);
    }
}

} // namespace process
