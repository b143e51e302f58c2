#include "core/render/splats/finer_in_cells.h"

#include "core/cells/local_boolean.h"
#include "core/render/splats/best_cut.h"

#include <algorithm>

namespace render {

using base::Vec3d, base::Vec3f;
using cells::CellSource, cells::Meeting;
using surface::Need;

namespace {

/// Of a crease: with less both sides are nearly one, and discs blend.
constexpr double leastSharpness = 0.5;
/// Sine of the angle between disc and cell below which they meet in no line that could be told.
constexpr double leastSine = 0.05;
/// As far behind a line, in radii, what it ends must be gone; on narrow faces a little farther (cells/README 3).
constexpr double behind = 0.1, farBehind = 0.6;
/// Discs beyond an edge go back to it; at corners to the next one too.
constexpr int mostMoves = 4;
/// Of the support: how near to a foot steps are done; one more has the square of that as its error.
constexpr double settled = 2e-3;
constexpr int mostSteps = 5;
constexpr double leastSlopeSq = 1e-4;

} // namespace

bool FinerInCells::concerns(const Vec3f& x) {
    m_source.moveTo(base::cast<double>(x));
    return m_source.count() > 1 || (m_source.count() == 1 && !m_source.absent(0).empty());
}

/// Moves y to a foot on the cell. The cell's place in the source, which is hardly off it.
std::optional<std::size_t> FinerInCells::footOf(Vec3d& y, std::uint32_t cell) {
    for (int step = 0; step < mostSteps; ++step) {
        m_source.moveTo(y);
        const std::size_t i = m_source.find(cell);
        if (i == CellSource::none)
            return std::nullopt;
        const auto& at = m_source.at(i, Need::Gradient);
        const double slopeSq = lengthSq(at.gradient);
        if (!cells::valid(at) || !(slopeSq > leastSlopeSq))
            return std::nullopt;
        y -= at.gradient * (at.value / slopeSq);
        if (std::abs(at.value) < settled * at.unit)
            return i;
    }
    return std::nullopt;
}

/// Of another cell at the source's position.
std::optional<FinerInCells::Level> FinerInCells::levelOf(std::size_t other, Meeting how) {
    const double sign = how == Meeting::Convex ? 1 : -1;
    const auto& at = m_source.at(other, Need::Gradient);
    if (cells::valid(at) && lengthSq(at.gradient) > leastSlopeSq)
        return Level{sign * at.value, at.gradient * sign};
    const CellSource::Tangent plane = m_source.tangent(other);
    if (!std::isfinite(plane.height))
        return std::nullopt;
    return Level{sign * plane.height, plane.normal * sign};
}

/// Where the level is zero in a plane through the position.
std::optional<FinerInCells::Edge> FinerInCells::edgeOf(const Level& level, const Vec3d& normal) {
    const Vec3d across = level.slope - normal * dot(level.slope, normal);
    const double steep = length(across);
    if (!(steep > leastSine * length(level.slope)))
        return std::nullopt;
    return Edge{across / steep, -level.value / steep};
}

double FinerInCells::toleranceHere(std::size_t i) {
    const Vec3d x = m_source.position();
    const double far = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    return cells::cutTolerance(m_source, m_source.at(i, Need::Value).unit, far);
}

bool FinerInCells::isCutOff(std::size_t i) {
    return cutOff(m_source, i, toleranceHere(i));
}

bool FinerInCells::isGone(std::uint32_t cell) {
    const std::size_t i = m_source.find(cell);
    return i == CellSource::none || !cells::valid(m_source.at(i, Need::Value)) || isCutOff(i);
}

/// Looks just behind the line where it is, and whether the cell is gone there.
void FinerInCells::follow(Edge& edge, const Vec3d& y, const Vec3d& normal, std::uint32_t cell, double within) {
    if (std::abs(edge.distance) > within) // too far off to be looked at
        return;
    const double looked = edge.distance + behind * within;
    m_source.moveTo(y + edge.direction * looked);
    const std::size_t i = m_source.find(cell), j = m_source.find(edge.other);
    edge.alone = isGone(cell);
    const bool both = i != CellSource::none && j != CellSource::none;
    if (const Meeting how = both ? m_source.meeting(i, j) : Meeting::None; how != Meeting::None)
        if (const auto level = levelOf(j, how))
            if (const auto nearer = edgeOf(*level, normal)) {
                edge.distance = nearer->distance + dot(nearer->direction, edge.direction) * looked;
                edge.direction = nearer->direction;
            }
    if (edge.alone)
        return;
    m_source.moveTo(y + edge.direction * (edge.distance + farBehind * within));
    edge.alone = isGone(cell);
}

/// All lines about the source's position, which lies on cell i, that are within twice a length, or have passed it.
void FinerInCells::findEdges(const Vec3d& normal, std::size_t i, double within) {
    m_edges.clear();
    const auto add = [&](const Level& level, std::uint32_t other) {
        if (auto edge = edgeOf(level, normal); edge && edge->distance < 2 * within) {
            edge->other = other;
            m_edges.push_back(*edge);
        }
    };
    for (std::size_t j = 0; j < m_source.count(); ++j) {
        const Meeting how = j == i ? Meeting::None : m_source.meeting(i, j);
        if (how == Meeting::None || m_source.sharpness(i, j) < leastSharpness)
            continue;
        if (const auto level = levelOf(j, how))
            add(*level, m_source.cell(j));
    }
    for (const cells::AbsentCell& each : m_source.absent(i))
        if (each.meeting() != Meeting::None && !(each.sharpness < leastSharpness * each.weight))
            if (const auto plane = cells::planeOf(m_source, i, each)) {
                const double sign = each.meeting() == Meeting::Convex ? 1 : -1;
                add({sign * plane->height, plane->normal * sign}, each.cell);
            }
}

bool FinerInCells::endsWithin(const Vec3f& x, std::uint32_t cell, float within) {
    Vec3d y = base::cast<double>(x);
    const auto i = footOf(y, cell);
    if (!i)
        return true;
    const auto wide = static_cast<double>(within);
    findEdges(base::normalized(m_source.at(*i, Need::Gradient).gradient), *i, wide);
    return std::any_of(m_edges.begin(), m_edges.end(), [&](const Edge& each) { return each.distance < wide; }) ||
           !isFace(m_source, *i, toleranceHere(*i));
}

bool FinerInCells::place(surfel::Surfel& disc, std::uint32_t cell, float far) {
    Vec3d y = base::cast<double>(disc.position);
    const auto i = footOf(y, cell);
    if (!i || distance(base::cast<float>(y), disc.position) > far || !isFace(m_source, *i, toleranceHere(*i)))
        return false;
    put(disc, y, m_source.at(*i, Need::Gradient).gradient);
    return true;
}

void FinerInCells::put(surfel::Surfel& disc, const Vec3d& y, const Vec3d& gradient) {
    disc.position = base::cast<float>(y);
    const Vec3f n = base::cast<float>(base::normalized(gradient));
    disc.normal = dot(n, disc.normal) < 0 ? -n : n;
}

bool FinerInCells::settle(surfel::Surfel& disc, std::uint32_t cell, float far, CutCode& code) {
    const auto radius = static_cast<double>(m_radius * disc.support);
    const Vec3d from = base::cast<double>(disc.position);
    Vec3d y = from, normal;
    code = wholeDisc;
    for (int moves = 0;; ++moves) {
        const auto i = footOf(y, cell);
        if (!i || distance(y, from) > static_cast<double>(far))
            return false;
        normal = base::normalized(m_source.at(*i, Need::Gradient).gradient);
        findEdges(normal, *i, radius);
        if (isFace(m_source, *i, toleranceHere(*i)))
            break;
        const auto worst = std::min_element(m_edges.begin(), m_edges.end(),
                                            [](const Edge& a, const Edge& b) { return a.distance < b.distance; });
        if (moves == mostMoves || worst == m_edges.end() || worst->distance > 0 || worst->distance < -radius ||
            !isCutOff(*i))
            return false;
        y += worst->direction * (worst->distance - 1e-4 * radius);
    }
    for (Edge& each : m_edges)
        follow(each, y, normal, cell, radius);
    // on narrow faces surface goes on a little beyond their edges, which discs would show
    for (const Edge& each : m_edges)
        if (each.alone && each.distance < 0) {
            const Vec3d back = each.direction * each.distance;
            y += back;
            for (Edge& other : m_edges)
                other.distance -= dot(other.direction, back);
        }
    put(disc, y, normal);
    std::vector<CutLine> lines;
    const Edge* together = nullptr;
    int others = 0;
    for (const Edge& each : m_edges)
        if (each.alone && each.distance < radius)
            lines.push_back(
                {base::cast<float>(each.direction), static_cast<float>(std::max(0.0, each.distance) / radius)});
        else if (!each.alone) {
            ++others;
            if (!together || each.distance > together->distance)
                together = &each;
        }
    // a reflex corner ends the disc behind both lines only: at the one farther off nothing is left of that
    if (others > 1 && together->distance > 0 && together->distance < radius)
        lines.push_back({base::cast<float>(together->direction), static_cast<float>(together->distance / radius)});
    std::sort(lines.begin(), lines.end(), [](const CutLine& a, const CutLine& b) { return a.part < b.part; });
    if (lines.size() == 1)
        code = oneCut(disc.normal, lines.front(), Beside::Edge);
    else if (!lines.empty())
        code = bestCut(disc.normal, disc.support, lines);
    return true;
}

} // namespace render
