#include "core/render/splats/disc_gaps.h"

#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

constexpr std::uint32_t sampledBlocks = 256;
constexpr std::size_t looked = 24;
/// Normals of one sheet; what stands above the plane by more than so much of its distance is another's.
constexpr float leastFacing = 0.3f, steepest = 0.7f;
/// A cell that reaches so far, in supports, has no end.
constexpr float endless = 1.5f;

struct Place {
    float x, y;
};

/// The part of a convex cell that is nearer to the origin than to `other`.
std::vector<Place> nearerPart(const std::vector<Place>& cell, const Place& other) {
    const float half = 0.5f * (other.x * other.x + other.y * other.y);
    const auto over = [&](const Place& p) { return p.x * other.x + p.y * other.y - half; };
    std::vector<Place> out;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const Place &a = cell[i], &b = cell[(i + 1) % cell.size()];
        const float overA = over(a), overB = over(b);
        if (overA <= 0)
            out.push_back(a);
        if ((overA <= 0) != (overB <= 0)) {
            const float t = overA / (overA - overB);
            out.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return out;
}

float farthest(const std::vector<Place>& cell) {
    float most = 0;
    for (const Place& p : cell)
        most = std::max(most, std::hypot(p.x, p.y));
    return most;
}

} // namespace

std::vector<float> sampleGaps(const tree::SurfelTree& tree) {
    std::vector<float> out;
    const int shape = surfel::shapeChannel(*tree.layout());
    const std::uint32_t step = std::max(1u, tree.blockCount() / sampledBlocks);
    std::vector<tree::Neighbour> near;
    for (std::uint32_t number = 0; number < tree.blockCount(); number += step) {
        const surfel::BlockPtr block = tree.block(number);
        const int slot = block->size() / 2;
        const base::Vec3f p = block->position(slot), n = block->normal(slot);
        const base::Vec3f u = base::perpendicular(n), v = cross(n, u);
        const float support = surfel::ballOf(*block, slot, shape), far = endless * support;
        std::vector<Place> cell{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
        tree.nearest(p, looked, near);
        for (const tree::Neighbour& each : near) {
            const base::Vec3f q = each.block->position(each.slot) - p;
            const bool ownSheet = std::abs(dot(each.block->normal(each.slot), n)) >= leastFacing &&
                                  std::abs(dot(q, n)) <= steepest * length(q);
            if (each.distanceSq > 0 && ownSheet)
                cell = nearerPart(cell, {dot(q, u), dot(q, v)});
        }
        if (const float gap = farthest(cell); gap > 0 && gap < far)
            out.push_back(gap / support);
    }
    return out;
}

} // namespace render
