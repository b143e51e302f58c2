#include "core/solid/loops/obstacles.h"

#include "core/process/resampling/point_grid.h"

#include <algorithm>

namespace solid {

using base::Vec3d;

namespace {

constexpr double near = 0.7;   ///< spacings: what is nearer is in the way
constexpr double beside = 4;   ///< spacings from the loop within which the model is what the patch goes on from
constexpr double folded = 0.5; ///< spacings between two vertices of one patch that nothing short joins
constexpr int enough = 3;      ///< one pair may be a sliver

process::PointGrid gridOf(std::span<const Vec3d> positions, const base::Box3d& box, double cell) {
    std::vector<process::PointGrid::Entry> entries;
    for (const Vec3d& p : positions)
        entries.push_back({base::cast<float>(p), static_cast<std::uint32_t>(entries.size())});
    process::PointGrid out(base::cast<float>(box.lo), static_cast<float>(std::max(cell, 1e-5 * box.diagonal())));
    out.build(entries);
    return out;
}

base::Box3d boxOf(const Patch& patch) {
    base::Box3d out;
    for (const Vec3d& p : patch.positions)
        out.extend(p);
    return out;
}

double widestOf(const Patch& patch) {
    return patch.spacings.empty() ? 0 : *std::ranges::max_element(patch.spacings);
}

} // namespace

bool meetsModel(const surface::Surface& surface, const Loop& loop, const Patch& patch) {
    std::vector<tree::Neighbour> found;
    for (std::size_t v = patch.loopSize; v < patch.positions.size(); ++v) {
        const Vec3d& p = patch.positions[v];
        surface.tree().nearest(base::cast<float>(p), 1, found, static_cast<float>(near * patch.spacings[v]));
        if (!found.empty() && std::ranges::none_of(loop.points, [&](const LoopPoint& each) {
                return distance(each.position, p) < beside * each.spacing;
            }))
            return true;
    }
    return false;
}

bool meet(const Patch& a, const Patch& b) {
    const base::Box3d box = boxOf(a);
    const double reach = near * std::max(widestOf(a), widestOf(b));
    if (!box.inflated(reach).overlaps(boxOf(b)))
        return false;
    const process::PointGrid grid = gridOf(a.positions, box, reach);
    bool met = false;
    for (std::size_t v = 0; v < b.positions.size() && !met; ++v) {
        const Vec3d& p = b.positions[v];
        const double within = near * b.spacings[v];
        grid.forNear(base::cast<float>(p), static_cast<float>(within),
                     [&](const auto& entry) { met |= distance(a.positions[entry.index], p) < within; });
    }
    return met;
}

bool crossesItself(const Patch& patch) {
    std::vector<std::vector<std::uint32_t>> joined(patch.positions.size());
    for (const mesh::Triangle& t : patch.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            for (const std::size_t next : {(k + 1) % 3, (k + 2) % 3})
                joined[t[k]].push_back(t[next]);
    const auto isNear = [&](std::uint32_t a, std::uint32_t b) { // along edges
        const auto has = [&](std::uint32_t of) { return std::ranges::find(joined[of], b) != joined[of].end(); };
        return a == b || has(a) || std::ranges::any_of(joined[a], has);
    };
    const process::PointGrid grid = gridOf(patch.positions, boxOf(patch), folded * widestOf(patch));
    int pairs = 0;
    for (std::uint32_t v = 0; v < patch.positions.size(); ++v) {
        const double within = folded * patch.spacings[v];
        grid.forNear(base::cast<float>(patch.positions[v]), static_cast<float>(within), [&](const auto& entry) {
            pairs += entry.index > v && patch.inside(entry.index) &&
                     distance(patch.positions[entry.index], patch.positions[v]) < within && !isNear(v, entry.index);
        });
    }
    return pairs >= enough;
}

} // namespace solid
