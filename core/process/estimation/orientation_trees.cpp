#include "core/process/estimation/orientation_trees.h"

#include "core/process/estimation/outside.h"

#include <algorithm>

namespace process {

/// Edges this unlike or less are certain: on two-sided scans, raw ones included, next to none of them contradicts the
/// others (at most 0.07 sqrt(n) points, found on 30 models), while a Moebius strip's seam of them cannot vanish.
constexpr std::size_t certain = unlikeClasses / 20;
constexpr double seamLength = 0.3; ///< in sqrt(n) points, from which there is a seam
constexpr std::size_t leastSeam = 4;

bool hasSeam(base::ParitySets& trees, const NormalLinks& links, std::size_t points) {
    std::vector<std::uint32_t> seam;
    for (std::size_t e = 0; e < links.edges.size(); ++e) {
        if (links.likenesses[e].unlike >= certain)
            continue;
        const auto a = trees.find(links.edges[e].a), b = trees.find(links.edges[e].b);
        if (a.root == b.root && (a.opposite != b.opposite) != links.likenesses[e].flip)
            seam.insert(seam.end(), {links.edges[e].a, links.edges[e].b});
    }
    std::sort(seam.begin(), seam.end());
    const auto length = static_cast<std::size_t>(std::unique(seam.begin(), seam.end()) - seam.begin());
    return length >= leastSeam && static_cast<double>(length) >= seamLength * std::sqrt(static_cast<double>(points));
}

void takeSigns(base::ParitySets& trees, const Cloud& cloud, std::span<base::Vec3f> normals, Sides given,
               const base::Progress& progress) {
    const std::size_t n = cloud.size();
    std::vector<std::uint32_t> start(n + 1), members(n), rootOf(n);
    std::vector<std::uint8_t> flipped(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto [root, flip] = trees.find(i);
        flipped[i] = flip;
        if (flip)
            normals[i] = -normals[i];
        rootOf[i] = root;
        ++start[root + 1];
    }
    for (std::size_t i = 0; i < n; ++i)
        start[i + 1] += start[i];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i)
        members[next[rootOf[i]]++] = i;
    const Outside outside(cloud.positions());
    for (std::size_t root = 0; root < n; ++root) {
        const std::span<const std::uint32_t> component(members.data() + start[root], start[root + 1] - start[root]);
        if (component.empty())
            continue;
        progress.step(static_cast<double>(root) / static_cast<double>(n), "Orienting normals");
        const auto turned = static_cast<std::size_t>(
            std::count_if(component.begin(), component.end(), [&](std::uint32_t i) { return flipped[i] != 0; }));
        const bool unclear = given == Sides::Mostly && std::abs(outside.vote(normals, component)) < Outside::clear;
        if (unclear ? 2 * turned > component.size() : outside.inward(normals, component))
            for (const std::uint32_t i : component)
                normals[i] = -normals[i];
    }
}

} // namespace process
