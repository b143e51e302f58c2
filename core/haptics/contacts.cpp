#include "core/haptics/contacts.h"

#include <algorithm>

namespace haptics {

using base::Vec3d;

namespace {

constexpr double alike = 0.9; ///< least cosine of the normals of what is one foot

bool same(const Foot& a, const Foot& b) {
    constexpr double near = 0.02; // of h
    return distance(a.position, b.position) <= near * std::min(a.unit, b.unit) && dot(a.normal, b.normal) >= alike;
}

/// Does this surfel belong to the sheet about the foot, so that it leads to no other?
bool sameSheet(const Foot& foot, const Vec3d& p, const Vec3d& n, double support) {
    constexpr double off = 0.1; // of h, from the tangent plane
    const Vec3d d = p - foot.position;
    return lengthSq(d) <= support * support && std::abs(dot(d, foot.normal)) <= off * support &&
           (n == Vec3d{} || std::abs(dot(n, foot.normal)) >= alike);
}

} // namespace

bool Contacts::add(const Foot& foot, const Vec3d& centre) {
    for (const Foot& known : feet())
        if (same(known, foot))
            return false;
    if (m_count < most) {
        m_feet[m_count++] = foot;
        return true;
    }
    const auto farthest = std::max_element(m_feet.begin(), m_feet.end(), [&](const Foot& a, const Foot& b) {
        return a.height(centre) < b.height(centre);
    });
    if (farthest->height(centre) <= foot.height(centre))
        return false;
    *farthest = foot;
    return true;
}

void Surroundings::collect(const surface::Surface& surface, const Vec3d& centre, double radius, Contacts& contacts) {
    constexpr std::size_t surfels = 12;
    constexpr double around = 0.5; // of h: how far beyond the tool feet are kept in mind
    constexpr int newSheets = 3;
    surface.tree().nearest(base::cast<float>(centre), surfels, m_found);
    m_room = std::numeric_limits<double>::infinity();
    m_unit = 0;
    int tried = 0;
    for (const tree::Neighbour& each : m_found) {
        const Vec3d p = base::cast<double>(each.block->position(each.slot));
        const double support = double(each.block->support(each.slot)), away = distance(p, centre);
        m_unit = m_unit > 0 ? m_unit : support;
        m_room = std::min(m_room, std::max(0.0, away - radius - support));
        if (away > radius + support || tried == newSheets)
            continue;
        const Vec3d n = base::cast<double>(each.block->normal(each.slot));
        const auto feet = contacts.feet();
        if (std::any_of(feet.begin(), feet.end(), [&](const Foot& f) { return sameSheet(f, p, n, support); }))
            continue;
        // which side the centre is on the foot tells: tangent planes of surfels beside it may pass in front
        const Vec3d up = lengthSq(n) > 0 ? n : base::normalized(centre - p, Vec3d{0, 0, 1});
        Foot foot;
        ++tried;
        const Tracked said = track(surface, centre, {p, up, 1, support}, foot);
        if (said != Tracked::Found && said != Tracked::Turned)
            continue;
        if (foot.height(centre) < 0)
            foot.turn();
        if (gapOf(foot, centre, radius) <= around * foot.unit)
            contacts.add(foot, centre);
    }
}

} // namespace haptics
