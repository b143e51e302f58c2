#include "core/cells/creases/surfel_links.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace cells {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr std::size_t ring = 6;                 ///< neighbours that spacing is told by
constexpr double spacingOfRing = 0.93;          ///< of their mean distance
constexpr double opposed = -0.5, upright = 0.8; ///< cosines: links from one side of a wall to the other

} // namespace

SurfelLinks::SurfelLinks(const tree::SurfelTree& tree, std::span<const surfel::Surfel> surfels)
    : m_surfels(surfels), m_near(surfels.size() * nearCount), m_nearCount(surfels.size()), m_spacing(surfels.size()) {
    findNear(tree);
    findSpacing();
    join();
}

void SurfelLinks::findNear(const tree::SurfelTree& tree) {
    m_first = tree.firstSurfels();
    base::parallelChunks(size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> found;
        for (std::size_t i = begin; i < end; ++i) {
            tree.nearest(m_surfels[i].position, nearCount + 1, found);
            for (const tree::Neighbour& each : found) {
                const std::uint32_t other = number(each);
                if (other != i && m_nearCount[i] < nearCount)
                    m_near[i * nearCount + m_nearCount[i]++] = other;
            }
        }
    });
}

/// That of the ring, evened out among neighbours.
void SurfelLinks::findSpacing() {
    std::vector<float> own(size());
    const auto count = static_cast<std::uint32_t>(size());
    base::parallelFor(count, 1024, [&](std::size_t n) {
        const auto i = static_cast<std::uint32_t>(n);
        const std::size_t few = std::min(ring, near(i).size());
        double sum = 0;
        for (const std::uint32_t other : near(i).first(few))
            sum += base::distance(at(i), at(other));
        own[i] = few > 0 ? static_cast<float>(spacingOfRing * sum / static_cast<double>(few)) : m_surfels[i].support;
    });
    base::parallelFor(count, 1024, [&](std::size_t n) {
        const auto i = static_cast<std::uint32_t>(n);
        double sum = static_cast<double>(own[i]);
        const auto around = near(i).first(std::min(linkCount, near(i).size()));
        for (const std::uint32_t other : around)
            sum += static_cast<double>(own[other]);
        m_spacing[i] = static_cast<float>(sum / static_cast<double>(around.size() + 1));
    });
}

void SurfelLinks::join() {
    const auto count = static_cast<std::uint32_t>(size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i < count; ++i)
        for (const std::uint32_t other : near(i).first(std::min(linkCount, near(i).size()))) {
            const double reach = linkReach * (spacing(i) + spacing(other)) / 2;
            if (base::distanceSq(at(i), at(other)) < reach * reach) {
                pairs.emplace_back(i, other);
                pairs.emplace_back(other, i);
            }
        }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    m_begin.assign(size() + 1, 0);
    m_links.resize(pairs.size());
    for (std::size_t e = 0; e < pairs.size(); ++e) {
        m_begin[pairs[e].first + 1] = static_cast<std::uint32_t>(e + 1);
        m_links[e].other = pairs[e].second;
    }
    for (std::size_t i = 1; i < m_begin.size(); ++i)
        m_begin[i] = std::max(m_begin[i], m_begin[i - 1]);
    base::parallelFor(pairs.size(), 4096, [&](std::size_t e) {
        const auto twin = std::lower_bound(pairs.begin(), pairs.end(), std::pair(pairs[e].second, pairs[e].first));
        m_links[e].twin = static_cast<std::uint32_t>(twin - pairs.begin());
    });
}

void SurfelLinks::cutWalls(std::span<const Vec3f> normals) {
    for (std::uint32_t i = 0; i < size(); ++i)
        for (std::uint32_t e = begin(i); e < end(i); ++e) {
            const Vec3f &n = normals[i], &m = normals[m_links[e].other];
            const Vec3f d = base::normalized(m_surfels[m_links[e].other].position - m_surfels[i].position);
            if (static_cast<double>(dot(n, m)) < opposed && static_cast<double>(std::abs(dot(n, d))) > upright &&
                static_cast<double>(std::abs(dot(m, d))) > upright)
                m_links[e].cut = Cut::Wall;
        }
}

} // namespace cells
