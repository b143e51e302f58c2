#include "core/process/estimation/neighbour_graph.h"

#include "core/process/estimation/part_progress.h"

namespace process {

namespace {

constexpr std::size_t fewest = 6;       ///< of the own side, that spacing is made of
constexpr float oppositeCosine = -0.5f; ///< normals that differ by more than 120 degrees are of two sides

/// The sum of normals at each position; none where they have no common side.
std::vector<base::Vec3f> sidesOf(const Cloud& cloud, const surfel::SurfelList& points) {
    std::vector<base::Vec3f> out;
    if (!points.layout->normals || !points.layout->oriented)
        return out;
    out.resize(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        out[cloud.places()[i]] += points.items[i].normal;
    return out;
}

/// Keeps the neighbours that look to the same side as `side`, in their order.
void keepSameSide(const base::Vec3f& side, const std::vector<base::Vec3f>& sides, Neighbours& near) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < near.size(); ++k) {
        const base::Vec3f& other = sides[near.index[k]];
        if (dot(side, other) < oppositeCosine * length(side) * length(other))
            continue;
        near.index[kept] = near.index[k];
        near.distanceSq[kept++] = near.distanceSq[k];
    }
    near.index.resize(kept);
    near.distanceSq.resize(kept);
}

} // namespace

NeighbourGraph neighbourGraph(const Cloud& cloud, const surfel::SurfelList& points, const base::Progress& progress) {
    const std::vector<base::Vec3f> sides = sidesOf(cloud, points);
    NeighbourGraph g{std::min(gradedNeighbours, cloud.size() - 1), {}, {}};
    g.index.resize(cloud.size() * g.count);
    g.distance.resize(cloud.size() * g.count);
    cloud.forEach(g.count, progress, "Measuring spacing", [&](std::size_t i, const Neighbours& nearest) {
        Neighbours own;
        const Neighbours* near = &nearest;
        if (!sides.empty()) {
            own = nearest;
            keepSameSide(sides[i], sides, own);
            if (own.size() < nearest.size()) {
                cloud.nearest(i, 2 * g.count, own);
                keepSameSide(sides[i], sides, own);
                near = own.size() >= fewest ? &own : &nearest;
            }
        }
        for (std::size_t k = 0; k < g.count; ++k) {
            const std::size_t from = std::min(k, near->size() - 1);
            g.index[i * g.count + k] = near->index[from];
            g.distance[i * g.count + k] = std::sqrt(near->distanceSq[from]);
        }
    });
    return g;
}

} // namespace process
