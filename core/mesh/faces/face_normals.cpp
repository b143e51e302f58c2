#include "core/mesh/faces/face_normals.h"

#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

static double angleAt(std::span<const Vec3f> positions, const Triangle& t, std::size_t k) {
    const Vec3d p = base::cast<double>(positions[t[k]]);
    const Vec3d a = base::cast<double>(positions[t[(k + 1) % 3]]) - p;
    const Vec3d b = base::cast<double>(positions[t[(k + 2) % 3]]) - p;
    return std::atan2(length(cross(a, b)), dot(a, b)); // no cosine, which loses half of the digits of small angles
}

/// Sums over corners, into the slot that `slotOf(corner, vertex)` names.
template <class SlotOf>
static std::vector<Vec3f> summed(const FaceTopology& topology, std::span<const Vec3f> positions, std::size_t slots,
                                 const SlotOf& slotOf) {
    std::vector<Vec3d> sums(slots), some(slots);
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t slot = slotOf(3 * t + k, topology.triangles[t][k]);
            sums[slot] += topology.normals[t] * angleAt(positions, topology.triangles[t], k);
            if (lengthSq(some[slot]) == 0)
                some[slot] = topology.normals[t];
        }
    std::vector<Vec3f> out(slots);
    constexpr double vanished = 1e-6; // of angles that are radians
    for (std::size_t i = 0; i < slots; ++i)
        out[i] = base::cast<float>(length(sums[i]) > vanished ? normalized(sums[i]) : some[i]);
    return out;
}

void joinFans(FaceTopology& topology, std::span<const Vec3f> positions, std::span<const SharpEdge> edges) {
    base::DisjointSets sets(topology.fanCount);
    const auto fanAt = [&](std::uint32_t triangle, const Vec3d& place) {
        std::size_t nearest = 0; // corners at one place may differ by round-off
        const auto corner = [&](std::size_t k) {
            return base::cast<double>(positions[topology.triangles[triangle][k]]);
        };
        for (std::size_t k = 1; k < 3; ++k)
            if (distanceSq(corner(k), place) < distanceSq(corner(nearest), place))
                nearest = k;
        return topology.fans[3 * std::size_t(triangle) + nearest];
    };
    for (const SharpEdge& edge : edges)
        for (const Vec3d& end : {edge.from, edge.to})
            sets.join(fanAt(edge.left, end), fanAt(edge.right, end));
    for (std::uint32_t& fan : topology.fans)
        fan = sets.find(fan);
}

std::vector<Vec3f> fanNormals(const FaceTopology& topology, std::span<const Vec3f> positions) {
    return summed(topology, positions, topology.fanCount,
                  [&](std::size_t corner, std::uint32_t) -> std::size_t { return topology.fans[corner]; });
}

static std::vector<Vec3f> aboutVertices(const FaceTopology& topology, std::span<const Vec3f> positions) {
    return summed(topology, positions, positions.size(),
                  [](std::size_t, std::uint32_t vertex) -> std::size_t { return vertex; });
}

std::vector<std::uint8_t> foldedOver(const FaceTopology& topology, std::span<const Vec3f> positions) {
    const std::vector<Vec3f> normals = aboutVertices(topology, positions);
    std::vector<std::uint8_t> out(topology.triangles.size());
    for (std::size_t t = 0; t < out.size(); ++t) {
        int away = 0;
        for (const std::uint32_t v : topology.triangles[t])
            away += dot(normals[v], base::cast<float>(topology.normals[t])) < 0 ? 1 : 0;
        out[t] = away > 1 ? 1 : 0;
    }
    return out;
}

std::vector<Vec3f> vertexNormals(const FaceTopology& topology, std::span<const Vec3f> positions) {
    constexpr float folded = 0.1f; // cosine
    const std::vector<Vec3f> all = aboutVertices(topology, positions);
    std::vector<Vec3f> out = all;
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        if (topology.areas[t] > 0)
            for (const std::uint32_t v : topology.triangles[t])
                if (dot(all[v], base::cast<float>(topology.normals[t])) < folded)
                    out[v] = {};
    return out;
}

} // namespace mesh
