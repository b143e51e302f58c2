#include "core/solid/seam_corner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace solid {

using base::Vec3d;

static constexpr double straight = 0.94; ///< cosine of 20 degrees

bool turnsBetween(const SeamPoint& a, const SeamPoint& b) {
    return dot(a.risesA, b.risesA) < straight || dot(a.risesB, b.risesB) < straight;
}

namespace {

using Function = std::function<SideValue(const Vec3d&)>;

/// A circle about a place on the surface that is smooth there, laid onto it; angles from forwards.
class Circle {
  public:
    Circle(const Function& smooth, const Function& other, const Vec3d& middle, const Vec3d& forwards, const Vec3d& up,
           double radius)
        : m_smooth(smooth), m_other(other), m_middle(middle), m_x(forwards), m_y(cross(up, forwards)), m_up(up),
          m_radius(radius) {}

    std::optional<Vec3d> at(double angle) const {
        Vec3d out = m_middle + (m_x * std::cos(angle) + m_y * std::sin(angle)) * m_radius;
        for (int step = 0; step < 3; ++step) {
            const SideValue there = m_smooth(out);
            if (!there.near || dot(there.gradient, m_up) < straight) // an edge of its own
                return {};
            out -= there.gradient * there.value;
        }
        return out;
    }
    /// Where the inside of the other solid ends that begins beside the way back.
    std::optional<Vec3d> end() const {
        using std::numbers::pi;
        const std::optional<bool> left = inside(pi - firstLook), right = inside(firstLook - pi);
        if (!left || !right || *left == *right)
            return {};
        const double way = *left ? -1 : 1; // from the side that is inside
        double from = way > 0 ? firstLook - pi : pi - firstLook;
        for (int look = 1; look <= looks; ++look) {
            const double to = from + way * (2 * (pi - firstLook) / looks);
            const std::optional<bool> there = inside(to);
            if (!there)
                return {};
            if (!*there)
                return between(from, to);
            from = to;
        }
        return {};
    }

  private:
    static constexpr double firstLook = 0.06; ///< radians off the way back: the least angle of a tip
    static constexpr int looks = 60;

    std::optional<bool> inside(double angle) const {
        const std::optional<Vec3d> place = at(angle);
        if (!place)
            return {};
        return m_other(*place).value < 0;
    }
    std::optional<Vec3d> between(double in, double out) const {
        constexpr int halvings = 24;
        for (int k = 0; k < halvings; ++k) {
            const double middle = 0.5 * (in + out);
            const std::optional<bool> there = inside(middle);
            if (!there)
                return {};
            (*there ? in : out) = middle;
        }
        return at(0.5 * (in + out));
    }

    const Function &m_smooth, &m_other;
    Vec3d m_middle, m_x, m_y, m_up;
    double m_radius;
};

/// Where three planes meet: two of the surface that turns, and the mean one of the other.
std::optional<SeamPoint> meetingOf(const SeamPoint& before, const SeamPoint& after, bool ofA, double within) {
    const auto turning = [ofA](const SeamPoint& p) { return ofA ? p.risesA : p.risesB; };
    const auto smooth = [ofA](const SeamPoint& p) { return ofA ? p.risesB : p.risesA; };
    const Vec3d n = turning(before), m = turning(after), k = normalized(smooth(before) + smooth(after));
    const double volume = dot(n, cross(m, k));
    if (std::abs(volume) < 0.01)
        return {};
    const Vec3d to = after.position - before.position;
    const Vec3d off = (cross(k, n) * dot(m, to) + cross(n, m) * (0.5 * dot(k, to))) / volume;
    if (length(off) > within || distance(before.position + off, after.position) > within)
        return {};
    SeamPoint out = before;
    out.position += off;
    return out;
}

} // namespace

std::optional<SeamTurn> aroundCorner(const TwoSides& sides, const SeamPoint& at, double forward, double spacing) {
    constexpr double radii[] = {0.06, 0.12, 0.25, 0.5}; // of the spacing
    for (const double part : radii)
        for (const bool ofA : {true, false}) {
            const double radius = part * spacing;
            const Circle circle(ofA ? sides.b : sides.a, ofA ? sides.a : sides.b, at.position, at.tangent() * forward,
                                ofA ? at.risesB : at.risesA, radius);
            const std::optional<Vec3d> place = circle.end();
            if (!place)
                continue;
            const std::optional<SeamPoint> next = seamPoint(sides, *place, seamTolerance * spacing);
            if (!next || distance(next->position, *place) > 0.2 * radius ||
                dot(ofA ? at.risesB : at.risesA, ofA ? next->risesB : next->risesA) < straight)
                continue;
            SeamTurn out{{}, *next};
            if (turnsBetween(at, *next)) {
                out.corner = meetingOf(at, *next, ofA, 2 * radius);
                if (!out.corner)
                    out.corner = SeamPoint{(at.position + next->position) / 2, at.risesA, at.risesB};
            }
            return out;
        }
    return {};
}

} // namespace solid
