#include "core/solid/fillet.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/solid/hexagonal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace solid {

using base::Vec3d;

namespace {

[[noreturn]] void refuse(double radius, const Vec3d& place, const char* why) {
    std::ostringstream text;
    text.precision(4);
    text << "no fillet of radius " << radius << " fits along the seam about " << place.x << ' ' << place.y << ' '
         << place.z << ": " << why;
    throw base::Error(text.str(), "fillet", "make it smaller, or leave the seam sharp");
}

constexpr double besideEdgeReach = 2; ///< spacings, as far as surfels have partners across an edge (cells/README 1.1)

/// Where the ball's middle would be if both surfaces were planes.
Vec3d middleOverPlanes(const SeamPoint& seam, const Vec3d& riseA, const Vec3d& riseB, double radius) {
    return seam.position + (riseA + riseB) * (radius / std::max(0.05, 1 + dot(riseA, riseB)));
}

} // namespace

TwoSides Fillet::heights() const {
    const auto above = [this](const Side& side, bool outside) {
        return [&side, sign = outside ? 1.0 : -1.0, radius = m_radius](const Vec3d& x) {
            const SideFoot foot = side.foot(x);
            return SideValue{sign * foot.height - radius, foot.gradient * sign, foot.ok};
        };
    };
    return {above(m_sides.model, m_sides.outsideModel), above(m_sides.operand, m_sides.outsideOperand)};
}

Fillet::Station Fillet::station(const SeamPoint& middle, double spacing) const {
    Station out{middle, {}, {}, 0, spacing};
    const Vec3d along = middle.tangent(), rises[2] = {middle.risesA, middle.risesB};
    for (int k = 0; k < 2; ++k)
        out.touch[k] = middle.position - rises[k] * m_radius;
    for (int k = 0; k < 2; ++k) {
        const Vec3d across = cross(along, rises[k]), other = out.touch[1 - k] - out.touch[k];
        out.toSeam[k] = dot(across, other) < 0 ? -across : across;
    }
    const double half = 0.5 * std::acos(std::clamp(dot(rises[0], rises[1]), -1.0, 1.0));
    out.reach = 1.5 * m_radius * std::tan(std::min(half, 1.5)) + 2 * spacing;
    return out;
}

/// Bent surfaces are touched farther from the seam than planes are.
double Fillet::farthestTouch(const Station& station, const std::vector<SeamCurve>& seams) {
    double out = 0;
    for (const Vec3d& touch : station.touch) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const SeamCurve& seam : seams)
            for (const SeamPoint& p : seam.points)
                nearest = std::min(nearest, distance(p.position, touch));
        out = std::max(out, nearest);
    }
    return out;
}

Fillet::Way Fillet::wayAlong(const SeamCurve& spine, const std::function<double(const Vec3d&)>& spacingAt) const {
    if (!spine.closed)
        refuse(m_radius, spine.points.back().position, "a ball of that size cannot roll on from there");
    if (!spine.corners.empty())
        refuse(m_radius, spine.points[spine.corners[0]].position, "the seam turns a corner there");
    Way out;
    for (const SeamPoint& middle : spine.points)
        out.push_back(station(middle, spacingAt(middle.position - middle.risesA * m_radius)));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Station &here = out[i], &next = out[(i + 1) % out.size()];
        const Vec3d step = next.middle.position - here.middle.position;
        for (int k = 0; k < 2; ++k) // a touch may rest, on an edge; it may not come back
            if (dot(next.touch[k] - here.touch[k], step) < -1e-3 * dot(step, step))
                refuse(m_radius, here.touch[k], "it bends more sharply than the ball");
    }
    return out;
}

Fillet::Fillet(const FilletSides& sides, double radius, const std::vector<SeamCurve>& seams,
               const std::function<double(const Vec3d&)>& spacingAt)
    : m_sides(sides), m_radius(radius), m_touches{{{}, 1}, {{}, 1}} {
    const TwoSides above = heights();
    std::vector<SeamSeed> seeds;
    for (const SeamCurve& seam : seams) {
        if (!seam.closed)
            refuse(radius, seam.points.back().position, "the seam ends there");
        const double spacing = spacingAt(seam.points[0].position);
        std::optional<SeamPoint> start;
        for (std::size_t i = 0; i < seam.points.size() && !start; i += 1 + seam.points.size() / 16) {
            const SeamPoint& at = seam.points[i];
            start = seamPoint(above,
                              middleOverPlanes(at, at.risesA * (sides.outsideModel ? 1 : -1),
                                               at.risesB * (sides.outsideOperand ? 1 : -1), radius),
                              seamTolerance * spacing);
            if (start && distance(start->position, at.position) > 4 * radius)
                start.reset();
        }
        if (!start)
            refuse(radius, seam.points[0].position, "no ball of that size touches both sides");
        seeds.push_back({start->position, spacing});
    }
    const std::vector<SeamCurve> spines = traceSeams(above, seeds);
    if (spines.size() != seams.size())
        refuse(radius, seams[0].points[0].position, "the balls of two seams meet");
    for (const SeamCurve& spine : spines)
        m_ways.push_back(wayAlong(spine, spacingAt));
    std::vector<process::PointGrid::Entry> entries[2];
    base::Box3d box;
    for (Way& way : m_ways)
        for (Station& each : way) {
            each.reach = std::max(each.reach, farthestTouch(each, seams) + 2 * each.spacing);
            for (int k = 0; k < 2; ++k) {
                entries[k].push_back({base::cast<float>(each.touch[k]), static_cast<std::uint32_t>(m_stations.size())});
                box.extend(each.touch[k]);
            }
            m_stations.push_back(&each);
            m_reach = std::max(m_reach, each.reach);
        }
    for (int k = 0; k < 2; ++k) {
        m_touches[k] = {base::cast<float>(box.lo), static_cast<float>(std::max(m_reach, 1e-5 * box.diagonal()))};
        m_touches[k].build(entries[k]);
    }
}

const Fillet::Station* Fillet::stationNear(bool ofOperand, const Vec3d& x, const Vec3d& normal) const {
    const int k = ofOperand ? 1 : 0;
    const Vec3d rise = (ofOperand ? m_sides.outsideOperand : m_sides.outsideModel) ? normal : -normal;
    const Station* nearest = nullptr;
    double least = m_reach;
    m_touches[k].forNear(base::cast<float>(x), static_cast<float>(m_reach), [&](const auto& entry) {
        const Station* each = m_stations[entry.index];
        if (dot(rise, ofOperand ? each->middle.risesB : each->middle.risesA) <= 0)
            return; // of another wall
        if (const double apart = distance(each->touch[k], x); apart < least)
            least = apart, nearest = each;
    });
    return nearest && least <= nearest->reach ? nearest : nullptr;
}

Fillet::Cover Fillet::cover(bool ofOperand, const Vec3d& x, const Vec3d& normal) const {
    const Station* at = stationNear(ofOperand, x, normal);
    if (!at)
        return Cover::Away;
    const int k = ofOperand ? 1 : 0;
    return dot(x - at->touch[k], at->toSeam[k]) > 0 ? Cover::Taken : Cover::Beside;
}

bool Fillet::besideEdge(bool ofOperand, const Vec3d& x, const Vec3d& normal) const {
    const Station* at = stationNear(ofOperand, x, normal);
    const int k = ofOperand ? 1 : 0;
    return at && std::abs(dot(x - at->touch[k], at->toSeam[k])) < besideEdgeReach * at->spacing;
}

/// From the touch on the ball to its middle, along the arc from one touch to the other.
Vec3d Fillet::towards(const SeamPoint& middle, double across) const {
    const double angle = std::acos(std::clamp(dot(middle.risesA, middle.risesB), -1.0, 1.0));
    if (angle < 1e-6)
        return middle.risesA;
    return normalized(middle.risesA * std::sin((1 - across) * angle) + middle.risesB * std::sin(across * angle));
}

FilletPlace Fillet::place(const Station& at, double across) const {
    const Vec3d up = towards(at.middle, m_sides.flat ? 0.5 : across);
    if (m_sides.flat)
        return {at.touch[0] + (at.touch[1] - at.touch[0]) * across,
                m_sides.concave() ? up : -up,
                at.touch[0],
                at.touch[1],
                across,
                at.spacing};
    return {
        at.middle.position - up * m_radius, m_sides.concave() ? up : -up, at.touch[0], at.touch[1], across, at.spacing};
}

void Fillet::rows(const Way& way, std::vector<FilletPlace>& out) const {
    double widest = 0, spacing = 0;
    for (const Station& each : way) {
        const double angle = std::acos(std::clamp(dot(each.middle.risesA, each.middle.risesB), -1.0, 1.0));
        const double length = m_sides.flat ? distance(each.touch[0], each.touch[1]) : angle * m_radius;
        widest = std::max(widest, length / each.spacing);
        spacing += each.spacing / static_cast<double>(way.size());
    }
    const int count = std::max(1, static_cast<int>(std::round(widest / rowStep)));
    const TwoSides above = heights();
    for (int row = 0; row <= count; ++row) {
        const double across = static_cast<double>(row) / count;
        std::vector<double> at(way.size() + 1, 0); // the way so far, in spacings
        for (std::size_t i = 0; i < way.size(); ++i) {
            const Station &here = way[i], &next = way[(i + 1) % way.size()];
            at[i + 1] = at[i] + distance(place(here, across).position, place(next, across).position) /
                                    (0.5 * (here.spacing + next.spacing));
        }
        const auto along = static_cast<std::size_t>(std::max(3.0, std::round(at.back() / alongStep)));
        const std::size_t first = out.size();
        out.resize(first + along);
        base::parallelFor(along, 8, [&](std::size_t j) {
            const double wanted = at.back() * (static_cast<double>(j) + 0.5 * (row & 1)) / static_cast<double>(along);
            const auto i = static_cast<std::size_t>(std::upper_bound(at.begin(), at.end(), wanted) - at.begin()) - 1;
            const Station &here = way[i], &next = way[(i + 1) % way.size()];
            const double part = (wanted - at[i]) / (at[i + 1] - at[i]);
            const auto middle =
                seamPoint(above, here.middle.position + (next.middle.position - here.middle.position) * part,
                          seamTolerance * here.spacing);
            out[first + j] = place(middle ? station(*middle, here.spacing) : here, across);
        });
    }
}

std::vector<FilletPlace> Fillet::places() const {
    std::vector<FilletPlace> all, out;
    for (const Way& way : m_ways) {
        base::CancelScope::check();
        rows(way, all);
    }
    // rows come close to each other where the arc is short, or the ball's way bends
    constexpr double apart = 0.7;
    base::Box3d box;
    double widest = 0;
    for (const FilletPlace& each : all) {
        box.extend(each.position);
        widest = std::max(widest, each.spacing);
    }
    process::PointGrid grid(base::cast<float>(box.lo), static_cast<float>(std::max(widest, 1e-5 * box.diagonal())));
    for (const FilletPlace& each : all) {
        bool free = true;
        grid.forNear(base::cast<float>(each.position), static_cast<float>(apart * each.spacing),
                     [&](const auto& entry) {
                         const FilletPlace& other = out[entry.index];
                         free = free && (distance(other.position, each.position) >= apart * each.spacing ||
                                         dot(other.normal, each.normal) < 0.17);
                     });
        if (!free)
            continue;
        grid.insert({base::cast<float>(each.position), static_cast<std::uint32_t>(out.size())});
        out.push_back(each);
    }
    return out;
}

std::vector<FilletPlace> Fillet::contacts() const {
    std::vector<FilletPlace> out;
    for (const Station* each : m_stations)
        out.push_back(place(*each, 0.5));
    return out;
}

} // namespace solid
