#include "ui/render/node_detail.h"

#include <algorithm>
#include <numeric>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

constexpr int most = surfel::blockCapacity;
/// Spacing of a surface's samples as a part of their supports, as usual.
constexpr float spacingOfSupport = 1 / 3.478f;

/// A child's surfels, and for each the representative that it is nearest to.
struct Members {
    int size = 0;
    float x[most], y[most], z[most], nx[most], ny[most], nz[most], support[most];
    float apart[most]; ///< squared distance from the nearest of those chosen
    int owner[most];   ///< its place among them

    explicit Members(const SurfelBlock& block) : size(block.size()) {
        for (int first = 0, c = 0; first < size; first += surfel::clusterSize, ++c) {
            const int count = std::min(surfel::clusterSize, size - first);
            const auto copy = [&](float* to, int channel) {
                std::copy_n(block.channel(c, channel), count, to + first);
            };
            copy(x, surfel::X), copy(y, surfel::Y), copy(z, surfel::Z);
            copy(nx, surfel::NormalX), copy(ny, surfel::NormalY), copy(nz, surfel::NormalZ);
            copy(support, surfel::Support);
        }
        std::fill_n(apart, size, std::numeric_limits<float>::infinity());
        std::fill_n(owner, size, 0);
    }

    /// Square of an edge of the area that each of `count` stands for.
    float share(int count) const {
        float sum = 0;
        for (int i = 0; i < size; ++i)
            sum += support[i] * support[i];
        return sum * spacingOfSupport * spacingOfSupport / static_cast<float>(count);
    }

    /// Squared distances as if normals that differ by an angle of a radian lay `sqrt(turn)` apart.
    void nearTo(int chosen, int place, float turn, bool oriented) {
        const float cx = x[chosen], cy = y[chosen], cz = z[chosen];
        const float ux = nx[chosen], uy = ny[chosen], uz = nz[chosen];
        for (int i = 0; i < size; ++i) {
            const float dx = x[i] - cx, dy = y[i] - cy, dz = z[i] - cz;
            const float cosine = nx[i] * ux + ny[i] * uy + nz[i] * uz;
            const float d = dx * dx + dy * dy + dz * dz + 2 * turn * (1 - (oriented ? cosine : std::abs(cosine)));
            owner[i] = d < apart[i] ? place : owner[i];
            apart[i] = d < apart[i] ? d : apart[i];
        }
    }

    /// Farthest-point sampling: up to `count`, fewer where places coincide. The owners count through `out`.
    int choose(int count, bool oriented, int* out) {
        const float turn = share(count);
        int k = 0;
        for (int next = 0; k < count; ++k) {
            if (k > 0 && apart[next] <= 0)
                break;
            out[k] = next;
            nearTo(next, k, turn, oriented);
            owner[next] = k, apart[next] = -1; // its own, whatever rounding and unknown normals say
            next = static_cast<int>(std::max_element(apart, apart + size) - apart);
        }
        return k;
    }
};

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
int represent(const SurfelBlock& block, const surfel::Colour* colours, int count, float radiusOfSupport, bool oriented,
              surfel::Surfel* out) {
    Members members(block);
    int chosen[most];
    count = members.choose(count, oriented, chosen);
    // In the order of the block, so that neighbours share clusters.
    int order[most], place[most];
    std::iota(order, order + count, 0);
    std::sort(order, order + count, [&](int a, int b) { return chosen[a] < chosen[b]; });
    for (int k = 0; k < count; ++k)
        place[order[k]] = k;
    Mean means[most];
    for (int i = 0; i < members.size; ++i) {
        surfel::Surfel member = block.surfel(i);
        member.colour = colours ? colours[i] : member.colour;
        means[place[members.owner[i]]].add(member, block.surfel(chosen[members.owner[i]]), oriented);
    }
    for (int k = 0; k < count; ++k)
        out[k] = means[k].surfel(block.surfel(chosen[order[k]]));
    for (int i = 0; i < members.size; ++i) {
        surfel::Surfel& own = out[place[members.owner[i]]];
        own.support =
            std::max(own.support, distance(block.position(i), own.position) / radiusOfSupport + members.support[i]);
    }
    return count;
}

float areaOf(const SurfelBlock& block) {
    float sum = 0;
    for (int i = 0; i < block.size(); ++i)
        sum += block.support(i) * block.support(i);
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
        size += represent(*parts[p], colours ? colours->of(parts[p]) : nullptr,
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
