#include "core/solid/loops/bridge_sheet.h"

#include "core/base/parallel.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <cmath>

namespace solid {

using base::Vec3d;

namespace {

/// The surface's normal at a place of a loop, from those two and four spacings behind it: at the loop itself, where
/// surfels are on one side only, the surface leans by some hundredths, which would show all the way across.
Vec3d normalAt(const surface::Surface& surface, const LoopPoint& p) {
    constexpr double step = 2; // in spacings
    Vec3d behind[2];
    for (int k = 0; k < 2; ++k) {
        const Vec3d place = p.position - p.outward * (step * (k + 1) * p.spacing);
        const auto foot =
            surface::projectReference(surface, place, {.checkBoundary = false}, {base::cast<float>(p.normal)});
        const Vec3d normal = foot.ok() ? normalized(foot.at.gradient) : p.normal;
        behind[k] = dot(normal, p.normal) < 0 ? -normal : normal;
        if (!foot.ok() || distance(foot.foot, place) > step * (k + 1) * p.spacing || dot(behind[k], p.normal) < 0.5)
            return p.normal;
    }
    return normalized(behind[0] * 2 - behind[1], p.normal);
}

/// From b to c, by the cubic of Catmull and Rom.
Vec3d between(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d, double t) {
    return b + (c - a) * (0.5 * t) + (a * 2 - b * 5 + c * 4 - d) * (0.5 * t * t) +
           (b * 3 - a - c * 3 + d) * (0.5 * t * t * t);
}

/// A loop by the way along it, from 0 to 1, with directions smoothed: those of single places carry the noise of the
/// samples beside them all the way across.
class Way {
  public:
    Way(const surface::Surface& surface, const Loop& loop) : m_loop(loop), m_at(loop.size() + 1, 0) {
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i)
            m_at[i + 1] = m_at[i] + distance(point(i).position, point(i + 1).position);
        for (double& each : m_at)
            each /= m_at[n] > 0 ? m_at[n] : 1;
        m_normals.resize(n);
        base::parallelFor(n, 4, [&](std::size_t i) { m_normals[i] = normalAt(surface, point(i)); });
    }
    /// Once it is known how long the sheet is. Means of directions leave the tangent planes, by as much where loops
    /// are round; how much is smoothed, too, as normals are noisy.
    void smooth(double length) {
        const std::size_t n = size();
        constexpr double reachOfWay = 0.15;
        constexpr std::size_t least = 3, partOfLoop = 12; // places; of the loop
        const auto wanted = static_cast<std::size_t>(reachOfWay * length / m_loop.meanSpacing());
        const std::size_t reach = std::clamp(wanted, least, std::max(least, n / partOfLoop));
        std::vector<Vec3d> outward(n);
        std::vector<double> off(n);
        for (std::size_t i = 0; i < n; ++i) { // across the loop as it is without its raggedness
            const Vec3d along = point(i + reach).position - point(i + n - reach).position;
            const Vec3d across = normalized(cross(along, m_normals[i]), point(i).outward);
            outward[i] = dot(across, point(i).outward) < 0 ? -across : across;
        }
        outward = meansAlong(outward, reach);
        for (std::size_t i = 0; i < n; ++i)
            off[i] = dot(outward[i], m_normals[i]);
        off = meansAlong(off, reach);
        m_normals = meansAlong(m_normals, least);
        for (std::size_t i = 0; i < n; ++i)
            m_outward.push_back(normalized(outward[i] - normalized(m_normals[i]) * off[i], point(i).outward));
        double shrinking = 0; // of the loop's length, for each length that it goes on
        for (std::size_t i = 0; i < n; ++i)
            shrinking -=
                dot(m_outward[(i + 1) % n] - m_outward[i], normalized(point(i + 1).position - point(i).position));
        constexpr double mostShrunk = 0.6;
        if (shrinking > 0)
            m_longest = mostShrunk * m_loop.length / shrinking;
    }
    /// A handle that is longer would draw the sheet together into a point.
    double longest() const { return m_longest; }
    double at(std::size_t i) const { return m_at[i]; }
    std::size_t size() const { return m_loop.size(); }

    /// Any way; whole numbers lead around.
    Vec3d position(double way) const {
        return along(way, [&](std::size_t k) { return point(k).position; });
    }
    Vec3d outward(double way) const {
        return normalized(along(way, [&](std::size_t k) { return m_outward[k % size()]; }));
    }

  private:
    template <class Fn>
    Vec3d along(double way, const Fn& of) const {
        const auto [i, t] = placeOnLoop(m_at, way);
        return between(of(i + size() - 1), of(i), of(i + 1), of(i + 2), t);
    }
    const LoopPoint& point(std::size_t i) const { return m_loop.points[i % size()]; }
    const Loop& m_loop;
    std::vector<double> m_at; ///< of each point, and 1
    std::vector<Vec3d> m_normals, m_outward;
    double m_longest = std::numeric_limits<double>::infinity();
};

/// How loops are compared: at so many places.
constexpr std::size_t mostCompared = 360;

struct Match {
    double shift = 0, meanSq = std::numeric_limits<double>::infinity();
};

/// The shift by which `to`, walked in a direction, comes nearest to `from`.
Match matched(const Way& from, const Way& to, double direction) {
    const std::size_t count = std::min(mostCompared, std::max(from.size(), to.size()));
    std::vector<Vec3d> a(count), b(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double way = static_cast<double>(k) / static_cast<double>(count);
        a[k] = from.position(way), b[k] = to.position(direction * way);
    }
    Match out;
    for (std::size_t shift = 0; shift < count; ++shift) {
        double sum = 0;
        for (std::size_t k = 0; k < count; ++k)
            sum += distanceSq(a[k], b[(k + shift) % count]);
        if (sum / static_cast<double>(count) < out.meanSq)
            out = {static_cast<double>(shift) / static_cast<double>(count), sum / static_cast<double>(count)};
    }
    return out;
}

double angleBetween(const Vec3d& a, const Vec3d& b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

} // namespace

BridgeSheet::BridgeSheet(const surface::Surface& surface, const Loop& from, const Loop& to) {
    Way a(surface, from), b(surface, to);
    const Match match = matched(a, b, -1), turned = matched(a, b, 1);
    m_againstTurned = std::sqrt(match.meanSq / std::max(turned.meanSq, 1e-300));
    a.smooth(std::sqrt(match.meanSq)), b.smooth(std::sqrt(match.meanSq));
    const std::size_t count = 2 * std::max(a.size(), b.size());
    for (std::size_t k = 0; k < count; ++k) {
        const double u = static_cast<double>(k) / static_cast<double>(count);
        const double w = -(u + match.shift);
        const Vec3d p = a.position(u), q = b.position(w), over = q - p, on = a.outward(u), back = b.outward(w);
        // a cubic that follows an arc of `turn` to 1e-4 of its radius, up to turns of 90 degrees; longer ones bulge
        // less
        const double turn = angleBetween(on, over) + angleBetween(back, -over);
        constexpr double leastSq = 0.35;
        const double c = std::cos(turn / 4), handle = length(over) / (3 * std::max(c * c, leastSq));
        m_rows.push_back({p, p + on * std::min(handle, a.longest()), q + back * std::min(handle, b.longest()), q});
        m_across += length(over) / static_cast<double>(count);
    }
    for (std::size_t i = 0; i < a.size(); ++i)
        m_places.push_back({a.at(i), 0});
    for (std::size_t j = 0; j < b.size(); ++j) {
        const double u = -b.at(j) - match.shift;
        m_places.push_back({u - std::floor(u), 1});
    }
}

Vec3d BridgeSheet::at(const SheetPlace& place) const {
    const std::size_t n = m_rows.size();
    const double along = (place.u - std::floor(place.u)) * static_cast<double>(n);
    const std::size_t i = std::min(static_cast<std::size_t>(along), n - 1);
    const double t = along - static_cast<double>(i), v = std::clamp(place.v, 0.0, 1.0), w = 1 - v;
    const auto row = [&](std::size_t k) {
        const Row& r = m_rows[k % n];
        return r.from * (w * w * w) + r.fromHandle * (3 * w * w * v) + r.toHandle * (3 * w * v * v) +
               r.to * (v * v * v);
    };
    return between(row(i + n - 1), row(i), row(i + 1), row(i + 2), t);
}

} // namespace solid
