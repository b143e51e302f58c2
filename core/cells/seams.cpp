#include "core/cells/seams.h"

#include "core/base/cancel_scope.h"
#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/segment.h"
#include "core/cells/feet.h"
#include "core/cells/local_boolean.h"
#include "core/cells/meeting_ends.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cells {

using base::Vec3d;
using surface::Evaluationd;
using surface::Need;

namespace {

constexpr double stepLength = 0.5;    ///< spacings
constexpr double shortestStep = 0.02; ///< spacings: steps are halved to this where a seam turns or ends
constexpr double taken = 0.4;         ///< spacings: feet so near to a seam belong to it
constexpr double takenWhereFlat = 1;  ///< the same, where feet are as uncertain as weights
constexpr double longestSpur = 4;     ///< spacings: shorter ways that run into a known seam are none of their own
constexpr double closing = 0.75;      ///< steps from the end to the beginning of what is closed
constexpr double farthestFoot = 3;    ///< spacings from a surfel beside the crease
constexpr double leastCosine = 0.8;   ///< of the turn in one step
constexpr double loose = 1e-3;        ///< spacings
constexpr double atCorner = 1;        ///< spacings between ends of seams that meet
constexpr double leastSharpness = 0.02;
constexpr double flatSineSq = 0.02;    ///< of the angle between both gradients
constexpr double looseWhereFlat = 0.1; ///< spacings
constexpr int mostFlatSteps = 12;
constexpr double flatStep = 0.3;    ///< of h, for all of the weight on one side
constexpr double leastWeight = 0.1; ///< of a cell, of the other's
constexpr double leastOwn = 0.02;   ///< the same on sharp seams

struct Start {
    Vec3d position;
    double spacing;
};
using Pair = std::pair<std::uint32_t, std::uint32_t>;

class PairTracer {
  public:
    PairTracer(const CellSurface& surface, const Pair& pair) : m_source(surface), m_pair(pair) {}

    void trace(std::span<const Start> starts, std::vector<Seam>& out) {
        for (const Start& start : starts)
            m_reach = std::max(m_reach, taken * start.spacing);
        const std::size_t first = out.size();
        for (const Start& start : starts) {
            base::CancelScope::check();
            const auto at = footNear(start.position, start.spacing, farthestFoot * start.spacing);
            if (!at || isTaken(*at, start.spacing))
                continue;
            Seam seam{m_pair.first, m_pair.second, {*at}, false, start.spacing};
            const Vec3d way = tangent(*at); // of this foot: marching forgets it
            const End end = march(way, start.spacing, seam.points);
            End back = End::Open;
            if (end != End::Closed) {
                std::reverse(seam.points.begin(), seam.points.end());
                back = march(-way, start.spacing, seam.points);
            }
            seam.closed = end == End::Closed || back == End::Closed;
            take(seam);
            if (!seam.closed && (joins(end, seam.points.front(), seam, first, out) ||
                                 joins(back, seam.points.back(), seam, first, out)))
                continue;
            const bool spur = !seam.closed && (end == End::Met || back == End::Met);
            if (seam.length() > (spur ? longestSpur : stepLength) * start.spacing)
                out.push_back(std::move(seam));
        }
    }

  private:
    /// A point of the seam at y's foot; nothing where there is none, or none that counts.
    std::optional<Vec3d> footNear(const Vec3d& y, double spacing, double within) {
        m_flat = isFlat(y);
        const auto foot = m_flat ? flatFoot(y, spacing) : sharpFoot(y);
        if (!foot || !(base::distance(*foot, y) < within))
            return std::nullopt;
        m_source.moveTo(*foot);
        const std::size_t i = m_source.find(m_pair.first), j = m_source.find(m_pair.second);
        const double tolerance = (m_flat ? looseWhereFlat : loose) * spacing;
        if (i == CellSource::none || j == CellSource::none || !isFace(m_source, i, tolerance) ||
            !isFace(m_source, j, tolerance) || !(m_source.sharpness(i, j) > leastSharpness))
            return std::nullopt;
        // far from one of them both go on as what is smooth to both, and agree without meeting
        const double a = m_source.sums(i).weight, b = m_source.sums(j).weight;
        if (std::min(a, b) < leastOwn * std::max(a, b) || isOfOthers(i, j, spacing))
            return std::nullopt;
        return foot;
    }
    /// Is the place nearer to other cells that meet in the same edge? Bands (crease_bands.h) end along an edge, creases
    /// without an angle run into it, and there cells on both sides have its zeros for some spacings.
    bool isOfOthers(std::size_t i, std::size_t j, double spacing) {
        std::vector<std::size_t> sides[2];
        for (std::size_t k = 0; k < m_source.count(); ++k) {
            if (k == i || (k != j && areOne(i, k, spacing)))
                sides[0].push_back(k);
            if (k == j || (k != i && areOne(j, k, spacing)))
                sides[1].push_back(k);
        }
        const double own = m_source.sums(i).weight * m_source.sums(j).weight;
        for (const std::size_t k : sides[0])
            for (const std::size_t l : sides[1])
                if ((k != i || l != j) && m_source.sums(k).weight * m_source.sums(l).weight > own &&
                    m_source.sharpness(k, l) > leastSharpness)
                    return true;
        return false;
    }
    /// Do two cells go on as one there?
    bool areOne(std::size_t i, std::size_t k, double spacing) {
        if (m_source.smooth(i, k))
            return true;
        const Evaluationd &at = m_source.at(i, Need::Gradient), &other = m_source.at(k, Need::Gradient);
        return valid(other) && std::abs(other.value) < looseWhereFlat * spacing && areFlat(at.gradient, other.gradient);
    }
    static bool areFlat(const Vec3d& g, const Vec3d& h) {
        return lengthSq(cross(g, h)) < flatSineSq * lengthSq(g) * lengthSq(h) && dot(g, h) > 0;
    }
    std::optional<Vec3d> sharpFoot(const Vec3d& y) {
        Feet feet(m_source, y, {});
        return feet.seam(m_pair.first, m_pair.second, y);
    }
    /// Do both patches go on as one there?
    bool isFlat(const Vec3d& y) {
        m_source.moveTo(y);
        const std::size_t i = m_source.find(m_pair.first), j = m_source.find(m_pair.second);
        if (i == CellSource::none || j == CellSource::none)
            return false;
        return areFlat(m_source.at(i, Need::Gradient).gradient, m_source.at(j, Need::Gradient).gradient);
    }
    /// Both zeros are everywhere then: where both cells have the same weight, on the surface that both are.
    std::optional<Vec3d> flatFoot(Vec3d y, double spacing) {
        const double reach = spacing / surface::spacingOfUnit;
        for (int k = 0; k < mostFlatSteps; ++k) {
            m_source.moveTo(y);
            const std::size_t i = m_source.find(m_pair.first), j = m_source.find(m_pair.second);
            if (i == CellSource::none || j == CellSource::none)
                return std::nullopt;
            double a = 0, b = 0;
            Vec3d middleA, middleB;
            m_source.forSurfels([&](const Vec3d& p, const Label& label, double distanceSq) {
                const double part = 1 - std::min(1.0, distanceSq / (reach * reach)), weight = part * part;
                if (label.cell == m_pair.first)
                    a += weight, middleA += p * weight;
                else if (label.cell == m_pair.second)
                    b += weight, middleB += p * weight;
            });
            if (!(a > leastWeight * b) || !(b > leastWeight * a))
                return std::nullopt;
            const Evaluationd& at = m_source.at(i, Need::Gradient);
            const Evaluationd& other = m_source.at(j, Need::Gradient);
            if (!valid(at) || !valid(other))
                return std::nullopt;
            const Vec3d n = base::normalized(at.gradient + other.gradient);
            Vec3d across = middleB / b - middleA / a;
            across = base::normalized(across - n * dot(across, n));
            m_across = across;
            y += across * (flatStep * reach * (a - b) / (a + b)) - n * ((at.value + other.value) / 2);
        }
        return y;
    }
    /// Along the seam, as both gradients tell.
    Vec3d tangent(const Vec3d& p) {
        m_source.moveTo(p);
        const std::size_t i = m_source.find(m_pair.first), j = m_source.find(m_pair.second);
        if (i == CellSource::none || j == CellSource::none)
            return {};
        if (m_flat)
            return base::normalized(cross(m_source.at(i, Need::Gradient).gradient, m_across));
        return base::normalized(
            cross(m_source.at(i, Need::Gradient).gradient, m_source.at(j, Need::Gradient).gradient));
    }
    /// How a way ends: somewhere, where it began, or on a seam that is known.
    enum class End { Open, Closed, Met };

    /// Appends points behind the last one. Of what closes the ring alone is left.
    End march(Vec3d way, double spacing, std::vector<Vec3d>& out) {
        const std::size_t before = out.size();
        const Vec3d start = out.back();
        Vec3d p = start;
        const double side = stepLength * spacing; // of a grid of the way so far
        base::CellMap<std::vector<std::uint32_t>> passed;
        for (double step = stepLength * spacing; step > shortestStep * spacing;) {
            base::CancelScope::check();
            const auto next = footNear(p + way * step, spacing, step);
            Vec3d turned = next ? tangent(*next) : Vec3d();
            if (dot(turned, way) < 0)
                turned = -turned;
            if (!next || !(dot(turned, way) > leastCosine) || !(dot(*next - p, way) > step / 2)) {
                step /= 2;
                continue;
            }
            p = *next;
            way = turned;
            std::optional<std::size_t> again = passedAt(passed, out, p, side); // it began on a spur of what closes
            if (out.size() > before + 3 && base::distance(p, start) < closing * stepLength * spacing)
                again = before - 1;
            if (again) {
                out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(*again));
                out.push_back(out.front());
                return End::Closed;
            }
            passed.at(base::cellOf(p, Vec3d(), 1 / side)).push_back(static_cast<std::uint32_t>(out.size()));
            out.push_back(p);
            if (isTaken(p, spacing))
                return End::Met;
            step = std::min(2 * step, stepLength * spacing);
        }
        return End::Open;
    }
    /// Which point of a way, not one of its last ones, is near a place.
    static std::optional<std::size_t> passedAt(const base::CellMap<std::vector<std::uint32_t>>& passed,
                                               const std::vector<Vec3d>& way, const Vec3d& p, double side) {
        std::optional<std::size_t> out;
        base::forCellsAround(base::cellOf(p, Vec3d(), 1 / side), [&](const base::Cell& cell) {
            if (const std::vector<std::uint32_t>* there = passed.find(cell))
                for (const std::uint32_t k : *there)
                    if (k + 4 < way.size() && base::distance(way[k], p) < side / 2 && (!out || k < *out))
                        out = k;
        });
        return out;
    }
    /// Where a seam has met the end of one that is known, because nothing led on from there, both become one.
    static bool joins(End end, const Vec3d& place, const Seam& seam, std::size_t first, std::vector<Seam>& out) {
        if (end != End::Met)
            return false;
        for (std::size_t k = first; k < out.size(); ++k) {
            std::vector<Vec3d>& known = out[k].points;
            const double reach = atCorner * seam.spacing;
            const bool front = base::distance(known.front(), place) < reach;
            if (out[k].closed || (!front && !(base::distance(known.back(), place) < reach)))
                continue;
            std::vector<Vec3d> more(seam.points);
            if (place == more.front())
                std::reverse(more.begin(), more.end()); // it ends where it meets the known one
            if (front)
                known.insert(known.begin(), more.begin(), more.end() - 1);
            else
                known.insert(known.end(), more.rbegin() + 1, more.rend());
            return true;
        }
        return false;
    }
    void take(const Seam& seam) {
        m_segments.reserve(m_segments.size() + seam.points.size());
        for (std::size_t k = 0; k + 1 < seam.points.size(); ++k)
            put(seam.points[k], seam.points[k + 1]);
        if (seam.points.size() == 1)
            put(seam.points.front(), seam.points.front());
    }
    double side() const { return 2 * (m_reach + stepLength / taken * m_reach); }
    void put(const Vec3d& from, const Vec3d& to) {
        m_segments.push_back({from, to});
        m_grid.at(base::cellOf((from + to) / 2, Vec3d(), 1 / side()))
            .push_back(static_cast<std::uint32_t>(m_segments.size() - 1));
    }
    bool isTaken(const Vec3d& p, double spacing) const {
        bool out = false;
        base::forCellsAround(base::cellOf(p, Vec3d(), 1 / side()), [&](const base::Cell& cell) {
            if (const std::vector<std::uint32_t>* there = m_grid.find(cell))
                for (const std::uint32_t k : *there) {
                    const auto& [from, to] = m_segments[k];
                    out |=
                        base::distance(p, nearestOnSegment(from, to, p)) < (m_flat ? takenWhereFlat : taken) * spacing;
                }
        });
        return out;
    }

    CellSource m_source;
    Pair m_pair;
    double m_reach = 0;  ///< of what is taken, at most
    bool m_flat = false; ///< was the last foot one where both patches go on as one?
    Vec3d m_across;      ///< there: from the first cell to the second
    std::vector<std::pair<Vec3d, Vec3d>> m_segments;
    base::CellMap<std::vector<std::uint32_t>> m_grid;
};

} // namespace

double Seam::length() const {
    double out = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
        out += base::distance(points[k], points[k + 1]);
    return out;
}

std::vector<Seam> traceSeams(const CellSurface& surface, const base::Progress& progress) {
    std::map<Pair, std::vector<Start>> starts;
    surface.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Label label = surface.labels().at(block, slot);
            if (label.meeting != Meeting::None)
                starts[std::minmax(label.cell, label.partner)].push_back(
                    {base::cast<double>(block.position(slot)),
                     static_cast<double>(block.support(slot)) * surface::spacingOfUnit});
        }
    });
    const std::vector<std::pair<Pair, std::vector<Start>>> pairs(starts.begin(), starts.end());
    std::vector<std::vector<Seam>> found(pairs.size());
    progress.step(0, "Following seams");
    base::parallelFor(pairs.size(), 1,
                      [&](std::size_t k) { PairTracer(surface, pairs[k].first).trace(pairs[k].second, found[k]); });
    std::vector<Seam> out;
    for (std::vector<Seam>& each : found)
        std::move(each.begin(), each.end(), std::back_inserter(out));
    return out;
}

std::vector<Vec3d> cornersOf(std::span<const Seam> seams) {
    std::vector<SeamEnd> ends;
    for (const Seam& seam : seams)
        if (!seam.closed && !seam.points.empty()) {
            ends.push_back({seam.points.front(), atCorner * seam.spacing});
            ends.push_back({seam.points.back(), atCorner * seam.spacing});
        }
    std::vector<Vec3d> out;
    for (const MeetingEnds& corner : meetingEnds(ends))
        out.push_back(corner.middle);
    return out;
}

} // namespace cells
