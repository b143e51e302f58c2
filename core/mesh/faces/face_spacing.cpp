#include "core/mesh/faces/face_spacing.h"

#include "core/base/ranked.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

constexpr double leastCount = 100'000;
/// What vertices may be instead of samples (mesh/README 8.2).
constexpr double coarsestEdges = 2.5; ///< over the spacing of `leastCount` samples, in the median: some 20,000 vertices
constexpr double mostSharp = 0.025;   ///< of the edges' length
constexpr float resolvedTurn = static_cast<float>(std::numbers::pi / 12); ///< of normals within a spacing: 15 degrees

static Vec3d corner(std::span<const Vec3f> positions, const Triangle& t, std::size_t k) {
    return base::cast<double>(positions[t[k % 3]]);
}

std::vector<float> vertexSpacings(const FaceTopology& topology, std::span<const Vec3f> positions) {
    std::vector<double> share(positions.size()), turn(positions.size());
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& f = topology.triangles[t];
            const Vec3d p = corner(positions, f, k), a = corner(positions, f, k + 1) - p,
                        b = corner(positions, f, k + 2) - p;
            share[f[k]] += topology.areas[t] / 3;
            turn[f[k]] += std::atan2(length(cross(a, b)), dot(a, b));
        }
    for (std::size_t i = 0; i < share.size(); ++i)
        if (turn[i] > 0)
            share[i] *= std::max(1.0, 2 * std::numbers::pi / turn[i]);
    std::vector<double> sum = share, weight(share.size(), 1);
    for (const Triangle& f : topology.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum[f[k]] += (share[f[(k + 1) % 3]] + share[f[(k + 2) % 3]]) / 2, ++weight[f[k]];
    std::vector<float> out(share.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = turn[i] > 0 ? static_cast<float>(std::sqrt(sum[i] / weight[i])) : 0;
    return out;
}

bool sampleWell(const FaceTopology& topology, std::span<const Vec3f> positions) {
    std::vector<float> edges, spacings, turns = topology.turns;
    for (const Triangle& f : topology.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back(distance(positions[f[k]], positions[f[(k + 1) % 3]]));
    for (const float s : vertexSpacings(topology, positions))
        if (s > 0)
            spacings.push_back(s);
    if (spacings.empty() || turns.empty())
        return false;
    const double samples = std::sqrt(topology.area / leastCount);
    return static_cast<double>(base::quantile(edges, 0.5)) < coarsestEdges * samples &&
           topology.sharpShare < mostSharp && base::quantile(turns, 0.95) < 2 * resolvedTurn &&
           base::quantile(spacings, 0.95) < 2.5f * base::quantile(spacings, 0.05);
}

bool hasBlades(const FaceTopology& topology, std::span<const SharpEdge> edges) {
    constexpr double blade = -0.5;
    return std::ranges::any_of(edges, [&](const SharpEdge& edge) {
        return edge.convex && dot(topology.normals[edge.left], topology.normals[edge.right]) < blade;
    });
}

} // namespace mesh
