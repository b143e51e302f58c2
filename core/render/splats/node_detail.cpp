#include "core/render/splats/node_detail.h"

#include "core/render/splats/farthest_points.h"

#include <algorithm>
#include <numeric>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

constexpr int most = surfel::blockCapacity;
/// Spacing of a surface's samples as a part of their supports, as usual.
constexpr float spacingOfSupport = 1 / 3.478f;

/// Sums over the members of a representative.
struct Mean {
    Vec3f offset, normal; ///< the offset is from the one chosen
    float red = 0, green = 0, blue = 0, alpha = 0, mask = 0, weight = 0;

    void add(const surfel::Surfel& s, const surfel::Surfel& chosen, bool oriented) {
        const float w = s.support * s.support;
        const bool turned = !oriented && dot(s.normal, chosen.normal) < 0;
        offset += (s.position - chosen.position) * w;
        normal += s.normal * (turned ? -w : w);
        red += w * static_cast<float>(s.colour & 255u), green += w * static_cast<float>(s.colour >> 8 & 255u);
        blue += w * static_cast<float>(s.colour >> 16 & 255u), alpha += w * static_cast<float>(s.colour >> 24);
        mask += w * s.mask;
        weight += w;
    }
    surfel::Surfel surfel(const surfel::Surfel& chosen) const {
        const float inverse = 1 / weight;
        const auto byte = [&](float sum) { return static_cast<surfel::Colour>(sum * inverse + 0.5f); };
        surfel::Surfel out;
        out.position = chosen.position + offset * inverse;
        out.normal = normalized(normal, chosen.normal);
        out.colour = byte(red) | byte(green) << 8 | byte(blue) << 16 | byte(alpha) << 24;
        out.mask = mask * inverse;
        out.support = 0;
        return out;
    }
};

/// Appends the representatives of one part.
int represent(const SurfelBlock& block, const surfel::Colour* colours, float area, int count, float radiusOfSupport,
              bool oriented, surfel::Surfel* out) {
    PointLanes members(block);
    int chosen[most];
    const float edge = spacingOfSupport * std::sqrt(area / static_cast<float>(count)); // of what each stands for
    count = members.choose(count, edge, oriented, chosen);
    // In the order of the block, so that neighbours share clusters.
    int order[most], place[most];
    std::iota(order, order + count, 0);
    std::sort(order, order + count, [&](int a, int b) { return chosen[a] < chosen[b]; });
    surfel::Surfel own[most];
    for (int k = 0; k < count; ++k) {
        place[order[k]] = k;
        own[k] = block.surfel(chosen[order[k]]);
    }
    Mean means[most];
    const auto placeOf = [&](int i) { return place[static_cast<int>(members.owner[i])]; };
    for (int i = 0; i < members.size; ++i) {
        surfel::Surfel member = block.surfel(i);
        member.colour = colours ? colours[i] : member.colour;
        means[placeOf(i)].add(member, own[placeOf(i)], oriented);
    }
    for (int k = 0; k < count; ++k)
        out[k] = means[k].surfel(own[k]);
    for (int i = 0; i < members.size; ++i) {
        surfel::Surfel& to = out[placeOf(i)];
        const Vec3f p{members.x[i], members.y[i], members.z[i]};
        to.support = std::max(to.support, distance(p, to.position) / radiusOfSupport + members.support[i]);
    }
    return count;
}

float areaOf(const SurfelBlock& block) {
    float sum = 0;
    for (int first = 0, c = 0; first < block.size(); first += surfel::clusterSize, ++c) {
        const float* support = block.channel(c, surfel::Support);
        for (int i = 0; i < std::min(surfel::clusterSize, block.size() - first); ++i)
            sum += support[i] * support[i];
    }
    return sum;
}

} // namespace

surfel::BlockPtr representatives(std::span<const SurfelBlock* const> parts, float radiusOfSupport, bool oriented,
                                 const BlockColours* colours) {
    float areas[surfel::laneCount], whole = 0;
    for (std::size_t p = 0; p < parts.size(); ++p)
        whole += areas[p] = areaOf(*parts[p]);
    surfel::Surfel found[most];
    int size = 0;
    const float shared = static_cast<float>(most - static_cast<int>(parts.size()));
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const int share = 1 + static_cast<int>(shared * areas[p] / whole);
        size += represent(*parts[p], colours ? colours->of(parts[p]) : nullptr, areas[p],
                          std::clamp(share, 1, std::min(parts[p]->size(), most - size)), radiusOfSupport, oriented,
                          found + size);
    }
    const surfel::MutableBlockPtr out = SurfelBlock::create(size, 0);
    for (int i = 0; i < size; ++i)
        out->set(i, found[i]);
    out->seal();
    return out;
}

NormalCone coneOf(const SurfelBlock& block) {
    Vec3f sum;
    for (int i = 0; i < block.size(); ++i)
        sum += block.normal(i);
    NormalCone out;
    out.axis = normalized(sum, Vec3f{});
    float least = 1;
    for (int i = 0; i < block.size(); ++i) {
        if (lengthSq(block.normal(i)) < 0.25f)
            return {};
        least = std::min(least, dot(block.normal(i), out.axis));
    }
    if (lengthSq(out.axis) > 0)
        out.angleRad = std::acos(std::clamp(least, -1.0f, 1.0f)) + 1e-3f;
    return out;
}

NormalCone coneOf(std::span<const NormalCone> cones) {
    Vec3f sum;
    for (const NormalCone& cone : cones) {
        if (cone.all())
            return {};
        sum += cone.axis;
    }
    NormalCone out;
    out.axis = normalized(sum, Vec3f{});
    if (lengthSq(out.axis) == 0)
        return {};
    out.angleRad = 0;
    for (const NormalCone& cone : cones)
        out.angleRad = std::max(out.angleRad,
                                std::acos(std::clamp(dot(cone.axis, out.axis), -1.0f, 1.0f)) + cone.angleRad + 1e-3f);
    return out;
}

} // namespace render
