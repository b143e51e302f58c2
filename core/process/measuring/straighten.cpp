#include "core/process/measuring/straighten.h"

#include "core/base/parallel.h"
#include "core/process/measuring/surface_walker.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace process {

using base::Vec3d;
using surface::Surface;

namespace {

constexpr double pitch = 0.35; // of h between two points
using Chain = std::vector<SurfacePlace>;

struct Pair { // of a point's two numbers
    double a = 0, b = 0;
};
struct Block { // [aa ab; ba bb]
    double aa = 0, ab = 0, ba = 0, bb = 0;

    Pair operator*(const Pair& v) const { return {aa * v.a + ab * v.b, ba * v.a + bb * v.b}; }
    Block operator*(const Block& o) const {
        return {aa * o.aa + ab * o.ba, aa * o.ab + ab * o.bb, ba * o.aa + bb * o.ba, ba * o.ab + bb * o.bb};
    }
    Block transposed() const { return {aa, ba, ab, bb}; }
    double determinant() const { return aa * bb - ab * ba; }
    Block inverse() const {
        const double d = 1 / determinant();
        return {bb * d, -ab * d, -ba * d, aa * d};
    }
};

/// The quadratic form of E around a chain, in the tangent planes of its inner points.
struct Form {
    std::vector<Block> diagonal, next; ///< of each inner point; with the one behind it
    std::vector<Pair> gradient;
    std::vector<std::array<Vec3d, 2>> basis; ///< zero where a point cannot go
};

/// Without a solution where the form, damped, has no least place.
bool solve(const Form& form, double damping, std::vector<Pair>& out) {
    const std::size_t n = form.diagonal.size();
    std::vector<Block> inverse(n);
    out.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        Block s = form.diagonal[i];
        const double more = damping * (s.aa + s.bb);
        s.aa += more, s.bb += more;
        Pair g{-form.gradient[i].a, -form.gradient[i].b};
        if (i > 0) {
            const Block back = form.next[i - 1].transposed(), lower = back * inverse[i - 1];
            const Block less = lower * form.next[i - 1];
            s.aa -= less.aa, s.ab -= less.ab, s.ba -= less.ba, s.bb -= less.bb;
            const Pair moved = lower * out[i - 1];
            g.a -= moved.a, g.b -= moved.b;
        }
        if (!(s.aa > 0) || !(s.determinant() > 1e-14 * s.aa * s.aa))
            return false;
        inverse[i] = s.inverse();
        out[i] = g;
    }
    for (std::size_t i = n; i-- > 0;) {
        Pair rest = out[i];
        if (i + 1 < n) {
            const Pair moved = form.next[i] * out[i + 1];
            rest.a -= moved.a, rest.b -= moved.b;
        }
        out[i] = inverse[i] * rest;
    }
    return true;
}

class Tightening {
  public:
    Tightening(const Surface& surface, Chain chain) : m_surface(surface), m_chain(std::move(chain)) {
        for (std::size_t i = 0; i + 1 < m_chain.size(); ++i)
            m_target.push_back(pitch * 0.5 * (m_chain[i].unit + m_chain[i + 1].unit));
    }

    /// Newton's method until nothing gets less any more.
    void run(const base::Progress& progress) {
        constexpr int most = 100;
        double damping = 1e-4, energy = energyOf(m_chain);
        for (int round = 0; round < most && m_chain.size() > 2; ++round) {
            progress.step(static_cast<double>(round) / most, "Straightening a way");
            const Form form = formOf();
            Chain next;
            double lower = energy;
            for (; damping < 1e6; damping *= 8)
                if (moved(form, damping, next) && (lower = energyOf(next)) < energy)
                    break;
            if (!(lower < energy))
                return;
            const bool still = energy - lower < 1e-11 * energy;
            m_chain = std::move(next), energy = lower;
            damping = std::max(1e-12, damping / 16);
            if (still)
                return;
        }
    }
    const Chain& chain() const { return m_chain; }

  private:
    double energyOf(const Chain& chain) const {
        double out = 0;
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            out += base::distanceSq(chain[i].position, chain[i + 1].position) / m_target[i];
        return out;
    }

    Form formOf() const {
        const std::size_t n = m_chain.size() - 2;
        Form out;
        out.diagonal.resize(n), out.next.resize(n), out.gradient.resize(n), out.basis.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const SurfacePlace& at = m_chain[i + 1];
            const double before = 1 / m_target[i], behind = 1 / m_target[i + 1];
            const Vec3d pull = (at.position - m_chain[i].position) * before -
                               (m_chain[i + 2].position - at.position) * behind; // half the gradient
            // Away from the surface nobody is pulled; back onto it, everybody may go.
            const bool held = at.rim && dot(pull, at.outward) < 0;
            const Vec3d u = held ? cross(at.normal, at.outward) : base::perpendicular(at.normal);
            const Vec3d v = held ? Vec3d{} : cross(at.normal, u);
            const double lift = dot(pull, at.normal);
            const auto second = [&](const Vec3d& x, const Vec3d& y) { return -lift * dot(x, at.bend * y); };
            const double stiff = before + behind;
            out.basis[i] = {u, v};
            out.gradient[i] = {dot(pull, u), dot(pull, v)};
            out.diagonal[i] = {stiff + second(u, u), second(u, v), second(u, v), stiff + second(v, v)};
            if (held)
                out.diagonal[i].ab = out.diagonal[i].ba = 0;
        }
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const auto& [u, v] = out.basis[i];
            const auto& [x, y] = out.basis[i + 1];
            const double k = -1 / m_target[i + 1];
            out.next[i] = {k * dot(u, x), k * dot(u, y), k * dot(v, x), k * dot(v, y)};
        }
        return out;
    }

    /// False where there is no least place. Points that cannot go where they should stay.
    bool moved(const Form& form, double damping, Chain& out) const {
        std::vector<Pair> by;
        if (!solve(form, damping, by))
            return false;
        out = m_chain;
        base::parallelFor(by.size(), 4, [&](std::size_t i) {
            const Vec3d way = form.basis[i][0] * by[i].a + form.basis[i][1] * by[i].b;
            if (const auto found = walkedBy(m_surface, m_chain[i + 1], way))
                out[i + 1] = *found;
        });
        return true;
    }

    const Surface& m_surface;
    Chain m_chain;
    std::vector<double> m_target; ///< between a point and the next
};

Chain knownOf(const std::vector<std::optional<SurfacePlace>>& found) {
    Chain out;
    for (const auto& each : found)
        if (each)
            out.push_back(*each);
    return out;
}

/// Places along a polyline as far apart as the surface wants them, but for those without a foot.
Chain resampled(const Surface& surface, const Chain& corners) {
    std::vector<double> at{0}; // in units of `pitch` h
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        at.push_back(at.back() + distance(corners[i].position, corners[i + 1].position) /
                                     (pitch * 0.5 * (corners[i].unit + corners[i + 1].unit)));
    const auto pieces = static_cast<std::size_t>(std::clamp(std::ceil(at.back()), 8.0, 1e6));
    std::vector<std::optional<SurfacePlace>> found(pieces + 1);
    found.front() = corners.front(), found.back() = corners.back();
    base::parallelFor(pieces - 1, 4, [&](std::size_t k) {
        const double here = at.back() * static_cast<double>(k + 1) / static_cast<double>(pieces);
        const auto behind = std::upper_bound(at.begin() + 1, at.end() - 1, here);
        const auto i = static_cast<std::size_t>(behind - at.begin()) - 1;
        const double span = at[i + 1] - at[i], share = span > 0 ? (here - at[i]) / span : 0;
        found[k + 1] = placeNear(surface, corners[i].position + (corners[i + 1].position - corners[i].position) * share,
                                 corners[i].normal);
    });
    return knownOf(found);
}

/// The corners themselves on the surface; those that have no foot are left out, but for the ends.
Chain landed(const Surface& surface, std::span<const Vec3d> way) {
    std::vector<std::optional<SurfacePlace>> found(way.size());
    base::parallelFor(way.size(), 4, [&](std::size_t i) {
        std::vector<tree::Neighbour> nearest;
        surface.tree().nearest(base::cast<float>(way[i]), 1, nearest);
        const Vec3d facing = base::cast<double>(nearest.front().block->normal(nearest.front().slot));
        found[i] = placeNear(surface, way[i], facing);
    });
    return found.front() && found.back() ? knownOf(found) : Chain{};
}

/// Does the surface go on from point to point?
bool isWhole(const Surface& surface, const Chain& chain) {
    const bool sided = surface.tree().layout()->oriented;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const double gap = distance(chain[i].position, chain[i + 1].position);
        const double alike = dot(chain[i].normal, chain[i + 1].normal);
        if (gap > 1.5 * std::max(chain[i].unit, chain[i + 1].unit) || (sided ? alike : std::abs(alike)) < -0.5)
            return false;
    }
    return true;
}

/// Of the arcs: each bends by the mean of the turns at its ends.
double lengthOf(const Chain& chain) {
    const std::size_t pieces = chain.size() - 1;
    const auto turn = [&](std::size_t i) { // at an inner point
        i = std::clamp<std::size_t>(i, 1, std::max<std::size_t>(1, pieces - 1));
        const Vec3d a = chain[i].position - chain[i - 1].position, b = chain[i + 1].position - chain[i].position;
        return std::atan2(length(cross(a, b)), dot(a, b));
    };
    double out = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
        const double half = pieces > 1 ? 0.25 * (turn(i) + turn(i + 1)) : 0;
        out += distance(chain[i].position, chain[i + 1].position) * (half > 1e-4 ? half / std::sin(half) : 1);
    }
    return out;
}

} // namespace

std::optional<Geodesic> straightened(const Surface& surface, std::span<const Vec3d> way,
                                     const base::Progress& progress) {
    constexpr int most = 6;
    constexpr double settled = 1e-5; // of the length
    Chain chain = landed(surface, way);
    double before = -1, now = chain.empty() ? 0 : lengthOf(chain);
    for (int round = 0; round < most && !chain.empty() && std::abs(now - before) > settled * now; ++round) {
        chain = resampled(surface, chain);
        Tightening tight(surface, std::move(chain));
        tight.run(progress);
        chain = tight.chain();
        before = now, now = lengthOf(chain);
    }
    if (chain.empty() || !isWhole(surface, chain))
        return {};
    Geodesic out;
    out.length = now;
    for (const SurfacePlace& each : chain)
        out.points.push_back({each.position, each.normal, each.unit, each.rim});
    return out;
}

} // namespace process
