#include "core/surface/projection/restarts.h"

namespace surface {

using base::Vec3f;

/// Surfels looked at first; eight times as many each time that these are all too close to a start already tried.
constexpr std::size_t fewest = 8, most = 4096;

Restarts::Restarts(const tree::SurfelTree& tree, const Vec3f& x) : m_tree(tree), m_x(x) {
    m_tree.nearest(m_x, fewest, m_found);
}

float Restarts::nearest() const {
    return m_found.empty() ? std::numeric_limits<float>::infinity() : std::sqrt(m_found.front().distanceSq);
}

const tree::Neighbour* Restarts::next(float limit) {
    for (;;) {
        for (; m_at < m_found.size(); ++m_at) {
            if (!(m_found[m_at].distanceSq < limit * limit))
                return nullptr;
            if (allowed(m_found[m_at]))
                return &m_found[m_at];
        }
        const std::size_t before = m_found.size();
        more();
        if (m_found.size() == before)
            return nullptr;
    }
}

void Restarts::more() {
    if (m_found.size() >= fewest && m_found.size() < most)
        m_tree.nearest(m_x, m_found.size() * 8, m_found);
}

void Restarts::tried(const tree::Neighbour& start, bool led) {
    const Vec3f p = start.block->position(start.slot);
    m_tried.push_back({p, led ? 0 : start.block->support(start.slot)});
}

bool Restarts::allowed(const tree::Neighbour& candidate) const {
    const Vec3f p = candidate.block->position(candidate.slot), way = p - m_x;
    for (const Tried& each : m_tried) {
        if (each.reach > 0) {
            if (distanceSq(p, each.position) < each.reach * each.reach)
                return false;
            continue;
        }
        const Vec3f other = each.position - m_x;
        if (dot(way, other) > 0.5f * length(way) * length(other)) // cos 60 degrees
            return false;
    }
    return true;
}

} // namespace surface
