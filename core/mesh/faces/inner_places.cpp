#include "core/mesh/faces/inner_places.h"

#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>

namespace mesh {

namespace {

using base::Vec3d;

constexpr std::uint64_t seed = 0x696e6e6572ULL;
constexpr std::size_t manyProbes = 20'000, probesPerBody = 8;
constexpr double leastShare = 0.01; ///< of the area, that is sampled in full

} // namespace

std::vector<std::uint32_t> InnerPlaces::sealedTriangles() const {
    std::vector<std::uint32_t> out;
    for (std::uint32_t t = 0; t < m_topology.triangles.size(); ++t)
        if (const std::uint32_t body = m_topology.bodies[t];
            body != noBody && m_topology.sealed[body] != 0 && m_topology.areas[t] > 0)
            out.push_back(t);
    return out;
}

InnerPlaces::InnerPlaces(const FaceTopology& topology, std::span<const base::Vec3f> positions)
    : m_topology(topology), m_positions(positions), m_sealed(sealedTriangles()), m_cells(topology, positions, m_sealed),
      m_depths(topology.sealed.size()) {
    if (!m_sealed.empty())
        judge();
}

/// On each body, even by area; by bodies.
std::vector<InnerPlaces::Probe> InnerPlaces::probes() const {
    std::vector<double> areas(m_depths.size());
    double sealed = 0;
    for (const std::uint32_t t : m_sealed) {
        areas[m_topology.bodies[t]] += m_topology.areas[t];
        sealed += m_topology.areas[t];
    }
    std::vector<std::uint32_t> order = m_sealed;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return m_topology.bodies[a] < m_topology.bodies[b]; });
    std::vector<Probe> out;
    double sum = 0, next = 0; // of the body's area so far; where the next probe is
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t t = order[i], body = m_topology.bodies[t];
        const auto wanted = static_cast<double>(probesPerBody) + std::floor(manyProbes * areas[body] / sealed);
        const double step = areas[body] / wanted;
        if (i == 0 || m_topology.bodies[order[i - 1]] != body)
            sum = 0, next = step / 2;
        for (sum += m_topology.areas[t]; next < sum; next += step) {
            base::Random random(base::mix(seed ^ out.size()));
            double u = random.uniform(), v = random.uniform();
            if (u + v > 1)
                u = 1 - u, v = 1 - v;
            const auto corner = [&](std::size_t k) {
                return base::cast<double>(m_positions[m_topology.triangles[t][k]]);
            };
            const Vec3d a = corner(0);
            out.push_back({a + (corner(1) - a) * u + (corner(2) - a) * v, t, step, {}});
        }
    }
    base::parallelFor(out.size(), 256,
                      [&](std::size_t i) { out[i].turns = m_cells.turnsAround(out[i].place, out[i].triangle); });
    return out;
}

/// What is inside on both sides is found on some places of each body. Where all of them are as deep, it is wholly
/// outside, or wholly inside of others.
void InnerPlaces::judge() {
    const std::vector<Probe> all = probes();
    std::vector<std::uint32_t> first(m_depths.size() + 1), buried; // first probe of each body; bodies deep in others
    for (const Probe& each : all)
        ++first[m_topology.bodies[each.triangle] + 1];
    for (std::size_t body = 0; body < m_depths.size(); ++body)
        first[body + 1] += first[body];
    double inner = 0;
    for (std::uint32_t body = 0; body < m_depths.size(); ++body) {
        const auto own = std::span(all).subspan(first[body], first[body + 1] - first[body]);
        double inside = 0;
        bool same = true;
        for (const Probe& each : own) {
            const auto& [outside, within] = each.turns;
            inside += outside >= 1 && within >= 1 ? each.weight : 0;
            same &= outside == own.front().turns.outside;
        }
        if (!same && inside > 0)
            m_depths[body] = Depth::Cut;
        else if (inside > 0 && own.front().turns.outside >= 2)
            buried.push_back(body);
        inner += m_depths[body] == Depth::Cut ? inside : 0;
    }
    std::vector<std::uint8_t> is(buried.size());
    base::parallelFor(buried.size(), 1, [&](std::size_t i) { is[i] = isBuried(all, first, buried[i]); });
    for (std::size_t i = 0; i < buried.size(); ++i)
        if (is[i] != 0) {
            m_depths[buried[i]] = Depth::Buried;
            for (std::uint32_t at = first[buried[i]]; at < first[buried[i] + 1]; ++at)
                inner += all[at].weight;
        }
    m_outerShare = std::max(leastShare, 1 - inner / m_topology.area);
}

/// Whether the bodies around it are not one in another, as dolls are: some of those of which a part is in others.
bool InnerPlaces::isBuried(std::span<const Probe> all, const std::vector<std::uint32_t>& firstProbes,
                           std::uint32_t body) const {
    std::vector<std::uint32_t> around = m_cells.bodiesAround(all[firstProbes[body]].place, body);
    std::erase_if(around, [&](std::uint32_t each) { return m_depths[each] != Depth::Cut; });
    return around.size() >= 2;
}

bool InnerPlaces::has(const Vec3d& place, std::uint32_t triangle) const {
    const std::uint32_t body = m_topology.bodies[triangle];
    if (body == noBody || m_depths[body] == Depth::Outside || m_topology.areas[triangle] == 0)
        return false;
    if (m_depths[body] == Depth::Buried)
        return true;
    return m_cells.isInside(place, triangle);
}

} // namespace mesh
