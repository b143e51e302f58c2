#include "core/tree/nearest_sequence.h"

#include "core/base/clones.h"

#include <cmath>

namespace tree {

namespace {

using surfel::clusterSize;

/// Where k is larger the ranking of what was picked costs more than a heap.
constexpr std::size_t mostAsked = 32;
constexpr std::size_t mostBlocks = 24;
/// Bounds are taken wider, so that rounding keeps nobody out for whom the tree had to be asked again.
constexpr float slack = 1e-5f;
/// Blocks are collected for so many times the distance that a position asks for.
constexpr float ahead = 2;
/// Where no position is.
constexpr float nowhere = std::numeric_limits<float>::infinity();
/// Below it squares of distances have lost their digits.
constexpr float leastSq = 1e-30f;

/// Appends those of the first `lanes` places that are within the radius; room for all is behind `count`.
POINTCLAY_CLONES
int pickCluster(const float* place, const float* x, int lanes, float radiusSq, float* distanceSq, std::int32_t* lane,
                int count) {
    float all[clusterSize];
    for (int i = 0; i < clusterSize; ++i) {
        const float dx = place[i] - x[0], dy = place[clusterSize + i] - x[1], dz = place[2 * clusterSize + i] - x[2];
        all[i] = dx * dx + dy * dy + dz * dz;
    }
    for (int i = 0; i < lanes; ++i) {
        distanceSq[count] = all[i];
        lane[count] = i;
        count += all[i] <= radiusSq ? 1 : 0;
    }
    return count;
}

/// How many of the values come before value i: smaller ones, and equal ones before it. `padded`: a multiple of 16.
POINTCLAY_CLONES
void countBefore(const float* value, int count, int padded, std::int32_t* before) {
    for (int i = 0; i < count; ++i) {
        const float own = value[i];
        std::int32_t sum = 0;
        for (std::int32_t j = 0; j < padded; ++j)
            sum += (value[j] < own ? 1 : 0) + ((value[j] == own ? 1 : 0) & (j < i ? 1 : 0));
        before[i] = sum;
    }
}

/// Squared distances of 16 places.
POINTCLAY_CLONES
void squaresFrom(const float* place, const float* x, float* out) {
    for (int i = 0; i < clusterSize; ++i) {
        const float dx = place[i] - x[0], dy = place[clusterSize + i] - x[1], dz = place[2 * clusterSize + i] - x[2];
        out[i] = dx * dx + dy * dy + dz * dz;
    }
}

} // namespace

NearestSequence::Known::Known() {
    for (auto& row : place)
        std::fill(std::begin(row), std::end(row), nowhere);
    std::fill(std::begin(farthest), std::end(farthest), nowhere);
}

/// So far away k are for sure.
float NearestSequence::Known::bound(const base::Vec3f& x) const {
    float squares[remembered];
    squaresFrom(place[0], &x.x, squares);
    const auto nearest = static_cast<std::size_t>(std::min_element(squares, squares + remembered) - squares);
    return std::sqrt(squares[nearest]) + farthest[nearest];
}

void NearestSequence::Known::add(const base::Vec3f& x, float distance) {
    for (std::size_t k = 0; k < 3; ++k)
        place[k][next] = x[k];
    farthest[next] = distance;
    next = (next + 1) % remembered;
}

/// Blocks by ascending number; false where they are too many.
bool NearestSequence::collect(const Node& node, std::uint32_t first, float radiusSq) {
    for (unsigned left = node.within(m_centre, radiusSq) & node.childMask(); left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t number = first + node.firstBlock[i];
        if (node.level > 1) {
            if (!collect(*node.nodes[i], number, radiusSq))
                return false;
        } else if (m_blocks.size() == mostBlocks) {
            return false;
        } else {
            m_blocks.push_back({node.blocks[i].get(), number});
        }
    }
    return true;
}

/// Are all blocks within `radius` of x among those collected, or can they be?
bool NearestSequence::expect(const base::Vec3f& x, float radius) {
    if ((distance(x, m_centre) + radius) * (1 + slack) <= m_collected)
        return true;
    for (const float wide : {ahead * radius, radius}) {
        m_centre = x;
        m_collected = wide;
        m_blocks.clear();
        if (collect(*m_tree.root(), 0, wide * wide * (1 + slack)))
            return true;
    }
    m_collected = -1;
    return false;
}

/// False where they are too few or too many.
bool NearestSequence::pick(const base::Vec3f& x, float radiusSq) {
    m_picked.count = 0;
    for (std::uint32_t b = 0; b < m_blocks.size(); ++b) {
        const surfel::SurfelBlock& block = *m_blocks[b].block;
        for (unsigned left = block.boundsLanes().within(x, radiusSq) & block.clusterMask(); left != 0;
             left &= left - 1) {
            const int cluster = std::countr_zero(left), first = cluster * clusterSize, from = m_picked.count;
            if (from + clusterSize > capacity)
                return false;
            m_picked.count =
                pickCluster(block.channel(cluster, surfel::X), &x.x, std::min(clusterSize, block.size() - first),
                            radiusSq, m_picked.distanceSq, m_picked.slot, from);
            for (int i = from; i < m_picked.count; ++i)
                m_picked.block[i] = b, m_picked.slot[i] += first;
        }
    }
    return static_cast<std::size_t>(m_picked.count) >= m_k;
}

void NearestSequence::rank(std::vector<Neighbour>& out) const {
    alignas(64) float value[capacity];
    std::int32_t before[capacity];
    const int count = m_picked.count, padded = (count + clusterSize - 1) / clusterSize * clusterSize;
    std::copy_n(m_picked.distanceSq, count, value);
    std::fill(value + count, value + padded, std::numeric_limits<float>::infinity());
    countBefore(value, count, padded, before);
    out.resize(m_k);
    for (int i = 0; i < count; ++i)
        if (static_cast<std::size_t>(before[i]) < m_k) {
            const NearBlock& from = m_blocks[m_picked.block[i]];
            out[static_cast<std::size_t>(before[i])] = {from.block, from.number, m_picked.slot[i], value[i]};
        }
}

void NearestSequence::at(const base::Vec3f& x, std::vector<Neighbour>& out) {
    const float radius = m_known.bound(x) * (1 + slack), radiusSq = radius * radius;
    if (radiusSq > leastSq && std::isfinite(radiusSq) && expect(x, radius) && pick(x, radiusSq))
        rank(out);
    else
        m_tree.nearest(x, m_k, out);
    if (m_k <= mostAsked && !out.empty() && out.size() == m_k)
        m_known.add(x, std::sqrt(out.back().distanceSq));
}

} // namespace tree
