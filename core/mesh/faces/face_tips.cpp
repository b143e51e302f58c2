#include "core/mesh/faces/face_tips.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace mesh {

namespace {

using base::Vec3d;

constexpr double leastTurn = 10 * std::numbers::pi / 180;
constexpr std::uint32_t none = ~0u;

double angleBetween(const Vec3d& n, const Vec3d& m) {
    return std::atan2(length(cross(n, m)), dot(n, m));
}

/// The side of a triangle across from its corner, the same for both triangles of a patch beside it.
std::uint64_t farSide(const FaceTopology& topology, std::size_t corner) {
    const std::size_t t = corner / 3, k = corner % 3;
    const std::uint32_t a = topology.fans[3 * t + (k + 1) % 3], b = topology.fans[3 * t + (k + 2) % 3];
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

/// Fans that do not go all around: there an edge ends them, and no tip is.
void leaveOutOpen(const FaceTopology& topology, std::vector<std::uint8_t>& tips) {
    std::unordered_map<std::uint64_t, int> spokes; // from each fan to the next around it
    for (std::size_t c = 0; c < topology.fans.size(); ++c)
        if (const std::uint32_t fan = topology.fans[c]; tips[fan] != 0)
            for (const std::size_t k : {(c % 3 + 1) % 3, (c % 3 + 2) % 3})
                ++spokes[std::uint64_t(fan) << 32 | topology.fans[c / 3 * 3 + k]];
    for (const auto& [spoke, count] : spokes)
        if (count != 2)
            tips[spoke >> 32] = 0;
}

} // namespace

std::vector<std::uint8_t> tipFans(const FaceTopology& topology, std::span<const base::Vec3f> fanNormals) {
    const std::size_t corners = topology.fans.size();
    std::vector<double> turn(topology.fanCount);
    for (std::size_t c = 0; c < corners; ++c)
        if (topology.areas[c / 3] > 0) {
            double& most = turn[topology.fans[c]];
            most =
                std::max(most, angleBetween(topology.normals[c / 3], base::cast<double>(fanNormals[topology.fans[c]])));
        }
    struct Side {
        std::uint32_t faces[2] = {none, none};
    };
    std::unordered_map<std::uint64_t, Side> sides; // far ones of what may be a tip
    for (std::size_t c = 0; c < corners; ++c)
        if (turn[topology.fans[c]] > leastTurn)
            sides.try_emplace(farSide(topology, c));
    std::vector<std::uint8_t> out(topology.fanCount);
    if (sides.empty())
        return out;
    for (std::size_t c = 0; c < corners; ++c)
        if (const auto side = sides.find(farSide(topology, c)); side != sides.end())
            side->second.faces[side->second.faces[0] == none ? 0 : 1] = static_cast<std::uint32_t>(c / 3);
    for (std::size_t fan = 0; fan < out.size(); ++fan)
        out[fan] = turn[fan] > leastTurn ? 1 : 0;
    leaveOutOpen(topology, out);
    for (std::size_t c = 0; c < corners; ++c) {
        std::uint8_t& tip = out[topology.fans[c]];
        if (tip == 0)
            continue;
        const auto& [a, b] = sides.at(farSide(topology, c)).faces;
        if (b != none && angleBetween(topology.normals[a], topology.normals[b]) >= turn[topology.fans[c]])
            tip = 0;
    }
    return out;
}

} // namespace mesh
