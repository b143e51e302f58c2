#include "core/process/estimation/drawn_lines.h"

#include "core/base/mat3.h"

#include <span>

namespace process {

namespace {

using base::Vec3d;

constexpr std::size_t mostLooked = 1024, nearest = 25; ///< itself among them
constexpr double flat = 1e-3;                          ///< of the length: rounding, no relief
constexpr double alongLine = 0.1;                      ///< of the variance along, across
constexpr double leastLines = 0.25;                    ///< of the places; those by chance in a plane: some .01

/// Of the variances along their own axes, the least first.
Vec3d variances(std::span<const Vec3d> places) {
    Vec3d mean;
    for (const Vec3d& p : places)
        mean += p / static_cast<double>(places.size());
    base::Mat3d c{};
    for (const Vec3d& p : places)
        c += base::outer(p - mean, p - mean);
    const auto& value = base::symmetricEigen(c).value;
    return {value[0], value[1], value[2]};
}

} // namespace

bool drawsLines(const tree::SurfelTree& tree) {
    if (tree.size() < 2 * nearest)
        return false;
    const std::size_t stride = (tree.size() + mostLooked - 1) / mostLooked;
    std::vector<Vec3d> looked, around;
    std::size_t at = 0, lines = 0;
    std::vector<tree::Neighbour> near;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (at++ % stride == 0)
                looked.push_back(base::cast<double>(block.position(slot)));
    });
    const Vec3d whole = variances(looked);
    if (!(whole.x <= flat * flat * whole.z))
        return false;
    for (const Vec3d& place : looked) {
        tree.nearest(base::cast<float>(place), nearest, near);
        around.clear();
        for (const tree::Neighbour& each : near)
            around.push_back(base::cast<double>(each.block->position(each.slot)));
        const Vec3d here = variances(around);
        lines += here.y < alongLine * here.z;
    }
    return static_cast<double>(lines) >= leastLines * static_cast<double>(looked.size());
}

} // namespace process
