#include "core/process/estimation/orientation/outside.h"

#include "core/base/clones.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
/// Rims of lenses and blades are thinner than the spacing, look to either side, and only they are asked: then what is
/// enclosed decides.
constexpr double leastEnclosed = 0.03;
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

/// Mean height of the middle below the points' planes, over their mean distance from it: 1 on a sphere, above zero on
/// what encloses something, inside out below.
double enclosedBy(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                  std::span<const std::uint32_t> members) {
    const Vec3d middle = mean(positions, members);
    double heights = 0, distances = 0;
    for (const std::uint32_t i : members) {
        const Vec3d from = base::cast<double>(positions[i]) - middle;
        heights += dot(from, base::cast<double>(normals[i]));
        distances += length(from);
    }
    return distances > 0 ? heights / distances : 0;
}

/// Of each direction the outermost of some members: the first one, where several are.
struct Outermost {
    float height[directions];
    std::uint32_t member[directions];
};

struct Directions {
    float x[directions], y[directions], z[directions];

    Directions() {
        for (int number = 0; number < directions; ++number) {
            const auto d = static_cast<double>(number);
            const double up = 1 - (2 * d + 1.0) / directions, angle = d * std::numbers::pi * (3 - std::sqrt(5.0));
            const double r = std::sqrt(1 - up * up);
            x[number] = static_cast<float>(r * std::cos(angle));
            y[number] = static_cast<float>(r * std::sin(angle));
            z[number] = static_cast<float>(up);
        }
    }
};

} // namespace

POINTCLAY_CLONES
static void lookAt(const Vec3f& p, std::uint32_t member, const Directions& d, Outermost& out) {
    for (int k = 0; k < directions; ++k) {
        const float height = p.x * d.x[k] + p.y * d.y[k] + p.z * d.z[k];
        const bool higher = height > out.height[k];
        out.height[k] = higher ? height : out.height[k];
        out.member[k] = higher ? member : out.member[k];
    }
}

double Outside::vote(std::span<const Vec3f> normals, std::span<const std::uint32_t> members) const {
    constexpr std::size_t grain = 16384;
    static const Directions all;
    std::vector<Outermost> parts(base::chunkCount(members.size(), grain));
    base::parallelChunks(members.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Outermost& out = parts[chunk];
        std::fill(std::begin(out.height), std::end(out.height), -std::numeric_limits<float>::infinity());
        std::fill(std::begin(out.member), std::end(out.member), members[begin]);
        for (std::size_t k = begin; k < end; ++k)
            lookAt(m_positions[members[k]], members[k], all, out);
    });
    double sum = 0;
    for (int k = 0; k < directions; ++k) {
        const Outermost* top = &parts.front();
        for (const Outermost& part : parts)
            top = part.height[k] > top->height[k] ? &part : top;
        sum += static_cast<double>(dot(normals[top->member[k]], Vec3f{all.x[k], all.y[k], all.z[k]}));
    }
    return sum / directions;
}

/// Few ask, and all points have a say.
const Outside::Extent& Outside::extent() const {
    std::call_once(m_once, [&] {
        const auto count = static_cast<double>(m_positions.size());
        for (const Vec3f& p : m_positions)
            m_extent.centre += base::cast<double>(p) / count;
        for (const Vec3f& p : m_positions)
            m_extent.radius += lengthSq(base::cast<double>(p) - m_extent.centre) / count;
        m_extent.radius = std::sqrt(m_extent.radius);
    });
    return m_extent;
}

bool Outside::inward(std::span<const Vec3f> normals, std::span<const std::uint32_t> members, double votes) const {
    if (std::abs(votes) >= clear)
        return votes < 0;
    const Vec3d facing = mean(normals, members);
    if (!(length(facing) >= facesOneWay)) {
        const double enclosed = enclosedBy(m_positions, normals, members);
        return std::abs(enclosed) > leastEnclosed ? enclosed < 0 : votes < 0;
    }
    if (static_cast<double>(members.size()) <= partOfAll * static_cast<double>(m_positions.size())) {
        const double away = dot(normalized(facing), mean(m_positions, members) - extent().centre);
        if (std::abs(away) > beside * extent().radius)
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
