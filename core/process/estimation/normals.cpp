#include "core/process/estimation/normals.h"

#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/least_direction.h"
#include "core/process/estimation/part_progress.h"

namespace process {

namespace {

/// Reach of the weight over the distance of the farthest neighbour: beyond 1, so that the farthest counts too.
constexpr double reachOverFarthest = 1.4;

void setFlags(surfel::SurfelList& points, bool oriented) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->normals = true;
    layout->oriented = oriented;
    points.layout = std::move(layout);
}

} // namespace

/// Least direction of the Wendland-weighted covariance about the weighted mean (process/README 2.1), relative to the
/// position itself.
base::Vec3f planeNormal(std::span<const base::Vec3f> positions, std::size_t i, std::span<const std::uint32_t> index,
                        std::span<const float> distanceSq) {
    const double reachSq = reachOverFarthest * reachOverFarthest * static_cast<double>(distanceSq.back());
    double w = 1, sum[3] = {}, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0; // the position itself: weight 1 at 0
    for (std::size_t k = 0; k < index.size(); ++k) {
        const base::Vec3d q = base::cast<double>(positions[index[k]] - positions[i]);
        const double r = std::sqrt(static_cast<double>(distanceSq[k]) / reachSq), u = 1 - r;
        const double weight = u * u * u * u * (4 * r + 1);
        const base::Vec3d v = q * weight;
        w += weight;
        sum[0] += v.x, sum[1] += v.y, sum[2] += v.z;
        xx += v.x * q.x, xy += v.x * q.y, xz += v.x * q.z, yy += v.y * q.y, yz += v.y * q.z, zz += v.z * q.z;
    }
    const base::Vec3d m{sum[0] / w, sum[1] / w, sum[2] / w};
    base::Mat3d c;
    c[0][0] = xx - w * m.x * m.x, c[0][1] = c[1][0] = xy - w * m.x * m.y, c[0][2] = c[2][0] = xz - w * m.x * m.z;
    c[1][1] = yy - w * m.y * m.y, c[1][2] = c[2][1] = yz - w * m.y * m.z, c[2][2] = zz - w * m.z * m.z;
    return base::normalized(base::cast<float>(leastDirection(c)), {0, 0, 1});
}

std::vector<base::Vec3f> normalsOf(const Cloud& cloud, int neighbours, const base::Progress& progress) {
    std::vector<base::Vec3f> out(cloud.size(), {0, 0, 1});
    if (cloud.size() > 2)
        cloud.forEach(static_cast<std::size_t>(neighbours), progress, "Estimating normals",
                      [&](std::size_t i, const Neighbours& near) {
                          out[i] = planeNormal(cloud.positions(), i, near.index, near.distanceSq);
                      });
    return out;
}

void estimateNormals(surfel::SurfelList& points, int neighbours, const base::Progress& progress) {
    const Cloud cloud(points.items, part(progress, 0, 0.2));
    const std::vector<base::Vec3f> normals = normalsOf(cloud, neighbours, part(progress, 0.2, 1));
    for (std::size_t i = 0; i < points.size(); ++i)
        points.items[i].normal = normals[cloud.places()[i]];
    setFlags(points, false);
}

bool orientNormals(surfel::SurfelList& points, int neighbours, const base::Progress& progress) {
    const Cloud cloud(points.items, part(progress, 0, 0.2));
    std::vector<base::Vec3f> normals(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        normals[cloud.places()[i]] = points.items[i].normal;
    const NeighbourTable links = nearestTable(cloud, static_cast<std::size_t>(neighbours), part(progress, 0.2, 0.5));
    if (!orient(cloud, links, normals, part(progress, 0.5, 1))) {
        setFlags(points, false);
        return false;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        // Coincident points may differ in their normals: each one turns towards what its place decided.
        base::Vec3f& n = points.items[i].normal;
        if (base::dot(n, normals[cloud.places()[i]]) < 0)
            n = -n;
    }
    setFlags(points, true);
    return true;
}

} // namespace process
