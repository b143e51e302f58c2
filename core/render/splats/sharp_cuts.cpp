#include "core/render/splats/sharp_cuts.h"

#include <algorithm>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// Cosine between the normals of two sides from which on there is an edge between them: 40 degrees, as in files with
/// faces (mesh/README 4.2).
constexpr float edgeCosine = 0.77f;
/// Discs farther apart than this, in sums of their radii, are not looked at: an edge between them cuts next to nothing.
constexpr float nearEnough = 0.8f;
/// Where all normals are this near (cosine) to their mean no two differ by as much as that.
constexpr float narrow = 0.94f;
/// Discs beyond an edge belong to one side while their normals differ by less (cosine).
constexpr float sameSide = 0.9f;
/// |mean normal| of a side from which on it counts as flat: where it is bent, no corners are looked for.
constexpr float flat = 0.985f;
/// One normal gone wrong makes no edge.
constexpr std::size_t leastBeyond = 2;
/// A cut is rounded to 32nds of a radius: by half of one it leaves no crack.
constexpr float slack = 0.5f / 32;

} // namespace

void SharpCuts::gather(const surfel::ClusterBounds& bounds) {
    m_near.size = 0;
    const float widest = m_radius * bounds.maxSupport;
    const auto reachOf = [&](float support) { return nearEnough * (widest + m_radius * support); };
    for (const Cluster& each : m_clusters) {
        if (!bounds.box.inflated(reachOf(each.bounds.maxSupport)).overlaps(each.bounds.box))
            continue;
        m_near.makeRoom(surfel::clusterSize);
        const float* from[7];
        float* to[7];
        for (int k = surfel::X; k <= surfel::Support; ++k) {
            from[k] = each.block->channel(each.number, k);
            to[k] = m_near.of[static_cast<std::size_t>(k)].data();
        }
        const int count = std::min(surfel::clusterSize, each.block->size() - each.number * surfel::clusterSize);
        for (int i = 0; i < count; ++i) { // what is out of reach is written over by the next
            const Vec3f p{from[surfel::X][i], from[surfel::Y][i], from[surfel::Z][i]};
            const float support = from[surfel::Support][i], reach = reachOf(support);
            for (int k = surfel::X; k < surfel::Support; ++k)
                to[k][m_near.size] = from[k][i];
            to[surfel::Support][m_near.size] = m_radius * support;
            m_near.size += bounds.box.distanceSq(p) <= reach * reach ? 1 : 0;
        }
    }
}

bool SharpCuts::mayHaveEdges() const {
    const auto like = [&](const Vec3f& n, const Vec3f& other) { return m_oriented || dot(n, other) >= 0 ? n : -n; };
    Vec3f mean;
    for (std::size_t i = 0; i < m_near.size; ++i)
        mean += like(m_near.normal(i), m_near.normal(0));
    mean = normalized(mean, Vec3f{});
    for (std::size_t i = 0; i < m_near.size; ++i)
        if (!(dot(like(m_near.normal(i), mean), mean) > narrow))
            return true;
    return false;
}

/// Which discs lie beyond an edge of this one. Those without a normal are nowhere beside it.
template <bool oriented>
void SharpCuts::findBeyond(const Disc& disc) {
    const auto& [x, y, z, nx, ny, nz, radius] = m_near.of;
    const std::size_t size = m_near.size;
    m_isBeyond.resize(size);
    const Vec3f c = disc.centre, n = disc.normal;
    const float radiusSq = disc.radius * disc.radius;
    for (std::size_t i = 0; i < size; ++i) {
        const float dx = x[i] - c.x, dy = y[i] - c.y, dz = z[i] - c.z;
        const float reach = nearEnough * (disc.radius + radius[i]);
        const float cosine = nx[i] * n.x + ny[i] * n.y + nz[i] * n.z;
        const float below = -(dx * n.x + dy * n.y + dz * n.z), beside = dx * nx[i] + dy * ny[i] + dz * nz[i];
        const bool differs = (oriented ? cosine : std::abs(cosine)) <= edgeCosine;
        const bool standsOut = oriented ? (below > 0) & (beside > 0) : (below != 0) & (beside != 0);
        const bool inReach =
            (dx * dx + dy * dy + dz * dz <= reach * reach) & (beside * beside < radiusSq * (1 - cosine * cosine));
        m_isBeyond[i] = differs & standsOut & inReach;
    }
    m_beyond.clear();
    for (std::size_t i = 0; i < size; ++i) {
        if (m_isBeyond[i] == 0)
            continue;
        const Vec3f way = m_near.centre(i) - c, normal = m_near.normal(i);
        const float cosine = dot(normal, n), beside = dot(way, normal);
        // Without a common sign: as if both faced away from what is between them.
        m_beyond.push_back(
            {way, beside < 0 ? -normal : normal, std::abs(beside) / std::sqrt(std::max(1e-30f, 1 - cosine * cosine))});
    }
}

/// Two planes meet in a line; seen from the disc it lies across the part of the other's normal along the disc.
CutCode SharpCuts::cutOf(const Disc& disc) {
    m_oriented ? findBeyond<true>(disc) : findBeyond<false>(disc);
    if (m_beyond.size() < leastBeyond)
        return wholeDisc;
    const Side side = sideOf(nearest([](const Beyond&) { return true; })->normal);
    const Vec3f across = side.normal - disc.normal * dot(side.normal, disc.normal);
    const float sine = length(across);
    if (side.count < leastBeyond || !(sine > 0))
        return wholeDisc;
    const float distance = dot(side.way, side.normal) / sine;
    return cutCode(disc.normal, across / sine, distance / disc.radius + slack,
                   side.flat && hasSecondEdge(side.normal, cutRadius * disc.radius) ? Beside::Corner : Beside::Edge);
}

/// Of those that `which` chooses, the one whose edge is nearest.
template <class Which>
const SharpCuts::Beyond* SharpCuts::nearest(const Which& which) const {
    const Beyond* best = nullptr;
    for (const Beyond& each : m_beyond)
        if (which(each) && (!best || each.distance < best->distance))
            best = &each;
    return best;
}

/// The mean of the discs beyond that face alike.
SharpCuts::Side SharpCuts::sideOf(const Vec3f& facing) const {
    Side out;
    for (const Beyond& each : m_beyond)
        if (dot(each.normal, facing) > sameSide)
            out.normal += each.normal, out.way += each.way, ++out.count;
    const float summed = length(out.normal), count = static_cast<float>(out.count);
    out.flat = summed > flat * count;
    out.normal = out.normal / std::max(summed, 1e-30f), out.way = out.way / std::max(count, 1.0f);
    return out;
}

/// Two flat sides beyond, and an edge between them: a corner.
bool SharpCuts::hasSecondEdge(const Vec3f& first, float within) const {
    const Beyond* other = nearest([&](const Beyond& each) { return dot(each.normal, first) < edgeCosine; });
    if (!other || other->distance > within)
        return false;
    const Side side = sideOf(other->normal);
    return side.count >= leastBeyond && side.flat;
}

bool SharpCuts::cut(const SurfelBlock& block, CutCodes& codes) {
    m_clusters.clear();
    m_model.forBlocksInSupport(
        block.box().inflated(m_radius * block.maxSupport()),
        [&](std::uint32_t, const SurfelBlock& each) {
            for (int c = 0; c < each.clusterCount(); ++c)
                m_clusters.push_back({&each, c, each.bounds(c)});
        },
        m_radius);
    bool any = false;
    for (int c = 0; c < block.clusterCount(); ++c) {
        gather(block.bounds(c));
        if (!mayHaveEdges())
            continue;
        const int first = c * surfel::clusterSize;
        for (int slot = first; slot < std::min(first + surfel::clusterSize, block.size()); ++slot) {
            CutCode& code = codes[static_cast<std::size_t>(slot)];
            const Vec3f n = block.normal(slot);
            if (code != wholeDisc || lengthSq(n) < 0.25f)
                continue;
            code = cutOf({block.position(slot), n, m_radius * block.support(slot)});
            any |= code != wholeDisc;
        }
    }
    return any;
}

} // namespace render
