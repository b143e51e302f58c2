#include "core/process/estimation/up_guess.h"

#include "core/base/ranked.h"

#include <algorithm>
#include <optional>

namespace process {

namespace {

using base::UpAxis;
using base::Vec3f;

constexpr std::size_t mostLookedAt = 32768;
constexpr double leftOut = 0.0025;     ///< of the surfels at either end of an axis: outliers
constexpr double largestWeight = 0.98; ///< quantile: what stands alone has a large support, but no area
constexpr float level = 0.8f;          ///< least |cosine| between a normal and the axis; noise tilts normals
constexpr double mostBelow = 0.03;     ///< of the area, below a ground plane
/// Of a ground plane; a ball's cap has .02 and .07.
constexpr double leastFlat = 0.03, leastSpread = 0.2, leastRest = 0.25, wholeOutline = 0.6;
constexpr double restsLess = 0.6, tallEnough = 0.7; ///< of what stands without a plane
constexpr double thinnest = 0.3, facingOfSheets = 0.45;
constexpr double larger = 1.25, muchLarger = 2.5; ///< planes that outdo the usual axis and side
constexpr double standsOn = 0.35;                 ///< rest of what stands
/// Of the area of what was seen from above: what looks up, what looks down for each of these, and what stands.
constexpr double leastSunny = 0.12, mostShady = 0.05, leastWalls = 0.3;
constexpr float upright = 0.2f;      ///< largest |cosine| between a wall's normal and the axis
constexpr float exactly = 0.999999f; ///< |cosine| between the normals of a built plane and an axis
constexpr double leastExact = 0.02;  ///< of the area, along each of two axes
/// Of the diagonal and of the height: how thick a layer is that counts as one plane.
constexpr double thick = 0.01, thickOfHeight = 0.04;

struct Sample {
    Vec3f position, normal;
    double weight; ///< area, in units of its own
};

std::vector<Sample> samplesOf(const tree::SurfelTree& tree) {
    const std::size_t step = tree.size() / mostLookedAt + 1;
    const Vec3f centre = tree.bounds().centre();
    std::vector<Sample> out;
    std::size_t next = 0, first = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        const auto size = static_cast<std::size_t>(block.size());
        for (; next < first + size; next += step) {
            const int slot = static_cast<int>(next - first);
            const auto h = static_cast<double>(block.support(slot));
            out.push_back({block.position(slot) - centre, block.normal(slot), h * h});
        }
        first += size;
    });
    std::vector<double> weights;
    for (const Sample& s : out)
        weights.push_back(s.weight);
    const double most = base::quantile(std::move(weights), largestWeight);
    for (Sample& s : out)
        s.weight = std::min(s.weight, most);
    return out;
}

/// Without those that stand apart along any axis.
std::vector<Sample> withoutOutliers(std::vector<Sample> samples, base::Box3f& box) {
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<float> places;
        for (const Sample& s : samples)
            places.push_back(s.position[k]);
        box.lo[k] = base::quantile(places, leftOut);
        box.hi[k] = base::quantile(std::move(places), 1 - leftOut);
    }
    const base::Box3f near = box.inflated(static_cast<float>(thick) * box.diagonal());
    std::erase_if(samples, [&](const Sample& s) { return !near.contains(s.position); });
    return samples;
}

struct Point {
    double x, y;
};

/// Of the convex hull, by Andrew's monotone chain [Andrew79].
double hullArea(std::vector<Point> points) {
    if (points.size() < 3)
        return 0;
    std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    const auto turn = [](Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    std::vector<Point> hull;
    for (int side = 0; side < 2; ++side, std::reverse(points.begin(), points.end())) {
        const std::size_t begin = hull.size();
        for (const Point p : points) {
            while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // where the other side begins
    }
    double twice = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point a = hull[i], b = hull[(i + 1) % hull.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return 0.5 * twice;
}

/// A model seen along one axis, from its lower end on.
class Standing {
  public:
    Standing(std::vector<Sample>& samples, std::size_t axis, double sign, double layer)
        : m_samples(samples), m_axis(axis), m_sign(sign), m_layer(layer) {
        std::sort(samples.begin(), samples.end(),
                  [this](const Sample& a, const Sample& b) { return height(a) < height(b); });
        for (const Sample& s : samples)
            m_total += s.weight;
        m_outline = hullArea(seen(0, samples.size(), 0));
    }

    LowerEnd lowerEnd() const {
        LowerEnd out;
        const auto [begin, end] = ground(out.flat);
        out.spread = share(seen(begin, end, level));
        const std::size_t touching = above(static_cast<std::size_t>(leftOut * static_cast<double>(m_samples.size())));
        out.rest = share(seen(0, touching, 0));
        double weight = 0;
        for (std::size_t i = 0; i < touching; ++i) {
            weight += m_samples[i].weight;
            out.slope += m_samples[i].weight * facing(m_samples[i]);
        }
        out.slope /= std::max(weight, 1e-300);
        out.flat /= m_total;
        return out;
    }

  private:
    double height(const Sample& s) const { return m_sign * static_cast<double>(s.position[m_axis]); }
    double facing(const Sample& s) const { return std::abs(static_cast<double>(s.normal[m_axis])); }
    double share(std::vector<Point> points) const {
        return m_outline > 0 ? hullArea(std::move(points)) / m_outline : 0;
    }
    /// The first sample above the layer that begins at `i`.
    std::size_t above(std::size_t i) const {
        const double top = height(m_samples[i]) + m_layer;
        while (i < m_samples.size() && height(m_samples[i]) <= top)
            ++i;
        return i;
    }

    std::vector<Point> seen(std::size_t begin, std::size_t end, double least) const {
        std::vector<Point> out;
        for (std::size_t i = begin; i < end; ++i)
            if (const Sample& s = m_samples[i]; facing(s) >= least)
                out.push_back({static_cast<double>(s.position[(m_axis + 1) % 3]),
                               static_cast<double>(s.position[(m_axis + 2) % 3])});
        return out;
    }

    /// The layer with the most of what is level in it, and hardly anything below.
    std::pair<std::size_t, std::size_t> ground(double& most) const {
        std::pair<std::size_t, std::size_t> out{0, 0};
        const auto levelWeight = [this](const Sample& s) {
            return facing(s) >= static_cast<double>(level) ? s.weight : 0;
        };
        double inside = 0, below = 0;
        std::size_t end = 0;
        for (std::size_t begin = 0; begin < m_samples.size() && below <= mostBelow * m_total; ++begin) {
            for (; end < m_samples.size() && height(m_samples[end]) <= height(m_samples[begin]) + m_layer; ++end)
                inside += levelWeight(m_samples[end]);
            if (inside > most)
                most = inside, out = {begin, end};
            inside -= levelWeight(m_samples[begin]);
            below += m_samples[begin].weight;
        }
        return out;
    }

    const std::vector<Sample>& m_samples;
    std::size_t m_axis;
    double m_sign, m_layer, m_total = 0, m_outline = 0;
};

} // namespace

UpEvidence upEvidence(const tree::SurfelTree& tree, KnownSides sides) {
    UpEvidence out;
    if (tree.empty())
        return out;
    base::Box3f box;
    std::vector<Sample> samples = withoutOutliers(samplesOf(tree), box);
    double total = 0;
    for (const Sample& s : samples)
        total += s.weight;
    for (std::size_t k = 0; k < 3; ++k) {
        out.extent[k] = static_cast<double>(box.size()[k]);
        for (const Sample& s : samples) {
            out.facing[k] += s.weight * std::abs(static_cast<double>(s.normal[k])) / total;
            out.looks[k] += sides == KnownSides::Yes ? s.weight * static_cast<double>(s.normal[k]) / total : 0;
            out.exact[k] += std::abs(s.normal[k]) >= exactly ? s.weight / total : 0;
            out.walls[k] += std::abs(s.normal[k]) <= upright ? s.weight / total : 0;
        }
    }
    for (const base::UpRow& row : base::upTable()) {
        const std::size_t axis = row.up.x != 0 ? 0 : row.up.y != 0 ? 1 : 2;
        const double layer = std::min(thick * static_cast<double>(box.diagonal()), thickOfHeight * out.extent[axis]);
        if (sides == KnownSides::Yes)
            for (const Sample& s : samples)
                out.sunny[static_cast<std::size_t>(row.axis)] +=
                    s.normal[axis] * static_cast<float>(row.up[axis]) >= level ? s.weight / total : 0;
        out.ends[static_cast<std::size_t>(row.axis)] = Standing(samples, axis, row.up[axis], layer).lowerEnd();
    }
    return out;
}

/// The up direction along an axis, positive or negative.
static UpAxis along(std::size_t axis, bool positive) {
    constexpr UpAxis table[3][2] = {
        {UpAxis::MinusX, UpAxis::X}, {UpAxis::MinusY, UpAxis::Y}, {UpAxis::MinusZ, UpAxis::Z}};
    return table[axis][positive];
}

static std::size_t axisOf(UpAxis up) {
    const base::Vec3d v = base::upRow(up).up;
    return v.x != 0 ? 0 : v.y != 0 ? 1 : 2;
}

static const LowerEnd& endOf(const UpEvidence& evidence, UpAxis up) {
    return evidence.ends[static_cast<std::size_t>(up)];
}

/// Area of a large level plane at that end; 0 where there is none. Either it is
/// nearly the whole outline, or nothing is below it: the flat back of a bust is
/// not what the bust stands on.
static double planeAt(const UpEvidence& evidence, UpAxis up) {
    const LowerEnd& end = endOf(evidence, up);
    const bool large = end.spread >= wholeOutline || (end.spread >= leastSpread && end.rest >= leastRest);
    return large && end.flat >= leastFlat ? end.flat : 0;
}

/// Terrains, coins and floors: thin, and most normals along the thin side.
static std::optional<std::size_t> thinSide(const UpEvidence& evidence) {
    const auto k = static_cast<std::size_t>(std::min_element(evidence.extent.begin(), evidence.extent.end()) -
                                            evidence.extent.begin());
    const double across = std::min(evidence.extent[(k + 1) % 3], evidence.extent[(k + 2) % 3]);
    const double thin = across > 0 ? evidence.extent[k] / across : 1;
    return thin <= thinnest && evidence.facing[k] >= facingOfSheets + thin ? std::optional(k) : std::nullopt;
}

/// Buildings and parts on a table that a drone or a scanner saw from above and around: much looks up and hardly
/// anything down, between walls. A single range scan faces its viewpoint as much, but it sees no walls.
static std::optional<UpAxis> seenFromAbove(const UpEvidence& evidence) {
    std::optional<UpAxis> out;
    for (std::size_t k = 0; k < 3; ++k)
        for (const bool positive : {false, true}) {
            const auto looking = [&](bool side) { return evidence.sunny[static_cast<std::size_t>(along(k, side))]; };
            if (looking(positive) < leastSunny || looking(!positive) > mostShady * looking(positive) ||
                evidence.walls[k] < leastWalls || planeAt(evidence, along(k, !positive)) > 0)
                continue;
            if (out)
                return {}; // a corner seen from within tells of two
            out = along(k, positive);
        }
    return out;
}

/// Which of the two ends of an axis is below. What stands on feet stands,
/// however flat its other end.
static UpAxis sideOf(const UpEvidence& evidence, std::size_t axis, UpAxis usual) {
    const UpAxis first = axisOf(usual) == axis ? usual : along(axis, true);
    const UpAxis other = along(axis, first != along(axis, true));
    const double here = planeAt(evidence, first), there = planeAt(evidence, other);
    if (endOf(evidence, first).rest >= standsOn)
        return first;
    return there > (here > 0 ? muchLarger * here : 0) ? other : first;
}

/// Feet, and what is cut off below: one end alone touches the ground in a wide
/// area, and the model is not flat above it.
static std::optional<UpAxis> standing(const UpEvidence& evidence) {
    const auto rest = [&](const base::UpRow& row) { return endOf(evidence, row.axis).rest; };
    const base::UpRow* best = &base::upTable().front();
    for (const base::UpRow& row : base::upTable())
        best = rest(row) > rest(*best) ? &row : best;
    for (const base::UpRow& row : base::upTable())
        if (&row != best && rest(row) > restsLess * rest(*best))
            return {};
    const double longest = *std::max_element(evidence.extent.begin(), evidence.extent.end());
    const bool tall = evidence.extent[axisOf(best->axis)] >= tallEnough * longest;
    return tall && rest(*best) >= leastRest ? std::optional(best->axis) : std::nullopt;
}

/// By the shape alone.
static UpAxis shapedUp(const UpEvidence& evidence, UpAxis usual) {
    if (const auto thin = thinSide(evidence); thin && std::abs(evidence.looks[*thin]) >= facingOfSheets)
        return along(*thin, evidence.looks[*thin] > 0);
    else if (thin)
        return *thin == axisOf(usual) ? usual : along(*thin, true);
    if (const auto seen = seenFromAbove(evidence))
        return *seen;
    std::array<double, 3> plane{};
    for (std::size_t k = 0; k < 3; ++k)
        plane[k] = std::max(planeAt(evidence, along(k, true)), planeAt(evidence, along(k, false)));
    const auto best = static_cast<std::size_t>(std::max_element(plane.begin(), plane.end()) - plane.begin());
    if (!(plane[best] > 0))
        return standing(evidence).value_or(usual);
    const std::size_t own = axisOf(usual);
    return sideOf(evidence, plane[best] > larger * plane[own] ? best : own, usual);
}

/// Planes along two axes, exact: machine parts, buildings, furniture, in the coordinates that they were made in.
static bool isBuilt(const UpEvidence& evidence) {
    return std::count_if(evidence.exact.begin(), evidence.exact.end(), [](double e) { return e >= leastExact; }) >= 2;
}

UpAxis guessedUp(const UpEvidence& evidence, UpAxis usual) {
    const UpAxis out = shapedUp(evidence, usual);
    const base::Vec3d& up = base::upRow(out).up;
    return up.x + up.y + up.z < 0 && isBuilt(evidence) ? usual : out;
}

} // namespace process
