#include "app/bench/brush_edit.h"

#include "core/base/random.h"

namespace bench {

using base::Vec3d;

BrushEdit brushEdit(const tree::SurfelTree& version, const surfel::Surfel& place, std::uint64_t seed) {
    BrushEdit out;
    std::vector<tree::Neighbour> near;
    version.nearest(place.position, std::min(brushEditSurfels, version.size() / 2), near);
    std::ranges::sort(near, {}, &tree::Neighbour::blockNumber);
    double radiusSq = 0;
    for (const tree::Neighbour& n : near) {
        if (out.edit.blocks.empty() || out.edit.blocks.back().block != n.blockNumber)
            out.edit.blocks.push_back({n.blockNumber, {}, {}});
        out.edit.blocks.back().removed.set(static_cast<std::size_t>(n.slot));
        out.removed.push_back(n.block->position(n.slot));
        radiusSq = std::max(radiusSq, static_cast<double>(n.distanceSq));
    }
    base::Random random(seed);
    const Vec3d normal = base::normalized(base::cast<double>(place.normal), {0, 0, 1});
    const Vec3d e1 = base::perpendicular(normal), e2 = base::cross(normal, e1);
    out.edit.inserted.layout = version.layout();
    const std::vector<std::uint32_t> words(version.layout()->words());
    for (std::size_t i = 0; i < near.size(); ++i) {
        const double r = std::sqrt(radiusSq * random.uniform()), angle = random.uniform(0, 6.283185307179586);
        surfel::Surfel s = place;
        s.position += base::cast<float>(e1 * (r * std::cos(angle)) + e2 * (r * std::sin(angle)));
        out.edit.inserted.append(s, words);
    }
    return out;
}

} // namespace bench
