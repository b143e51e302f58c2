#include "core/process/estimation/orientation/outside.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace process {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr int directions = 48;
/// |mean normal| from which on a component is a sheet with a direction that it faces; closed ones have 0, half a ball
/// 0.5.
constexpr double facesOneWay = 0.3;
/// Components up to this share of the points look away from the others, where these lie clearly (in root mean squares
/// of the cloud's radius) on one side of them.
constexpr double partOfAll = 0.5, beside = 0.2;

double largestComponent(const Vec3d& v) {
    double out = v.x;
    for (const double each : {v.y, v.z})
        out = std::abs(each) > std::abs(out) ? each : out;
    return out;
}

Vec3d mean(std::span<const Vec3f> values, std::span<const std::uint32_t> members) {
    Vec3d sum;
    for (const std::uint32_t i : members)
        sum += base::cast<double>(values[i]);
    return sum / static_cast<double>(members.size());
}

} // namespace

Outside::Outside(std::span<const Vec3f> positions) : m_positions(positions) {
    for (const Vec3f& p : positions)
        m_centre += base::cast<double>(p) / static_cast<double>(positions.size());
    for (const Vec3f& p : positions)
        m_radius += lengthSq(base::cast<double>(p) - m_centre) / static_cast<double>(positions.size());
    m_radius = std::sqrt(m_radius);
}

double Outside::vote(std::span<const Vec3f> normals, std::span<const std::uint32_t> members) const {
    std::array<double, directions> votes;
    base::parallelFor(directions, members.size() < 1024 ? directions : 1, [&](std::size_t number) {
        const auto d = static_cast<double>(number);
        const double z = 1 - (2 * d + 1.0) / directions, angle = d * std::numbers::pi * (3 - std::sqrt(5.0));
        const double r = std::sqrt(1 - z * z);
        const Vec3f direction = base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), z});
        const auto height = [&](std::uint32_t i) { return dot(m_positions[i], direction); };
        std::uint32_t top = members.front();
        for (const std::uint32_t i : members)
            if (height(i) > height(top))
                top = i;
        votes[number] = static_cast<double>(dot(normals[top], direction));
    });
    return std::accumulate(votes.begin(), votes.end(), 0.0) / directions;
}

bool Outside::inward(std::span<const Vec3f> normals, std::span<const std::uint32_t> members, double votes) const {
    const Vec3d facing = mean(normals, members);
    if (std::abs(votes) >= clear || !(length(facing) >= facesOneWay))
        return votes < 0;
    if (static_cast<double>(members.size()) <= partOfAll * static_cast<double>(m_positions.size())) {
        const double away = dot(normalized(facing), mean(m_positions, members) - m_centre);
        if (std::abs(away) > beside * m_radius)
            return away < 0;
    }
    return largestComponent(facing) < 0;
}

bool looksInwards(const tree::SurfelTree& tree) {
    constexpr std::size_t mostLookedAt = 65536;
    const std::size_t step = tree.size() / mostLookedAt + 1;
    std::vector<Vec3f> positions, normals;
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (at++ % step == 0) {
                positions.push_back(block.position(slot));
                normals.push_back(block.normal(slot));
            }
    });
    std::vector<std::uint32_t> members(positions.size());
    std::iota(members.begin(), members.end(), 0u);
    return !members.empty() && Outside(positions).vote(normals, members) <= -Outside::clear;
}

} // namespace process
