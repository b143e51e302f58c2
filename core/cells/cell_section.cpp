#include "core/cells/cell_section.h"

#include "core/base/cells.h"
#include "core/base/parallel.h"
#include "core/base/segment.h"
#include "core/cells/cell_value.h"
#include "core/cells/local_boolean.h"
#include "core/complexes/complex_section.h"
#include "core/surface/curves/curve_tracing.h"
#include "core/surface/curves/traced_lines.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>
#include <tuple>

namespace cells {

using base::Plane, base::Vec3d;
using surface::Need, surface::SectionCurve, surface::SectionPoint;

namespace {

constexpr int mostIterations = 30;
constexpr double tolerance = 1e-12;  ///< of the last step, in units of h
constexpr double longestStep = 0.3;  ///< of Newton's, in units of h
constexpr double leastSine = 1e-3;   ///< of the angle between plane and surface: below it they touch
constexpr double seedDistance = 0.3; ///< in units of h: surfels this near to the plane look for the section
constexpr double seedReach = 1;      ///< in units of h: a curve farther off than that is another surfel's
constexpr double onCurve = 0.02;     ///< in units of h: how far a point may be from the polyline of its curve
constexpr double sameCurve = 0.1;    ///< in units of h: two curves that are so close for half their way are one
constexpr double farBeyond = 0.05;   ///< in units of h: so much cut off there is nothing, though others are, too
constexpr double atCorners = 0.7;    ///< in units of h: off-centre values up to which cells have a surface
constexpr double goesOn = 0.9;       ///< cosine between the directions of two stretches that overlap
constexpr double smoothGap = 0.8;    ///< in units of h: between ends where a crease fades
constexpr double nearby = 0.15;      ///< in units of h: f in the middle of such a gap, at most
constexpr double ahead = 0.05;       ///< in units of h: so far beyond its end the curve may go on in another cell
constexpr double longestOverlap = 8; ///< in units of h: of two stretches of one curve
constexpr double joined = 0.05;      ///< in units of h: how far the ends of two curves may be apart at a seam

/// A point of a section, on the surface of a cell.
struct CellPoint : SectionPoint {
    std::uint32_t cell = noCell;
};

/// The curve of one cell, for surface::traceCurve.
class CellSection {
  public:
    using Point = CellPoint;

    CellSection(CellSource& source, const Plane& plane, std::uint32_t cell)
        : m_source(source), m_plane(plane), m_cell(cell) {}

    const surface::Surface& surface() const { return m_source.surface().surface(); }

    /// Newton's iteration in the plane.
    std::optional<CellPoint> find(const Vec3d& start, const surface::OrientationHint& = {}) const {
        Vec3d x = start - m_plane.normal * m_plane.distance(start);
        for (int k = 0; k < mostIterations; ++k) {
            m_source.moveTo(x);
            const std::size_t i = m_source.find(m_cell);
            if (i == CellSource::none)
                return std::nullopt;
            const surface::Evaluationd& at = m_source.at(i, Need::Gradient);
            if (!valid(at))
                return std::nullopt;
            const Vec3d& g = at.gradient;
            const Vec3d inPlane = g - m_plane.normal * dot(g, m_plane.normal);
            const double square = lengthSq(inPlane);
            if (!(square > leastSine * leastSine * lengthSq(g)))
                return std::nullopt;
            const Vec3d step = inPlane * (-at.value / square);
            const double size = length(step);
            if (!(size > std::max(tolerance * at.unit, CellSource::rounding * length(x)))) {
                if (!(std::abs(at.value) <= 1e-9 * at.unit))
                    return std::nullopt;
                CellPoint out;
                static_cast<SectionPoint&>(out) = {x, base::normalized(g), base::normalized(cross(m_plane.normal, g)),
                                                   at.unit};
                out.cell = m_cell;
                return out;
            }
            x += size > longestStep * at.unit ? step * (longestStep * at.unit / size) : step;
            x -= m_plane.normal * m_plane.distance(x);
        }
        return std::nullopt;
    }

    /// Is the surface there this cell's? Where cells are smooth to each other both have the curve, and where a crease
    /// fades each may cut the other off by what it is off.
    bool holds(const CellPoint& p) const {
        const CellValue there = evaluate(m_source, p.position, Need::Gradient);
        return there.cell == m_cell && there.at.status == surface::Status::Ok &&
               there.at.offCentre <= atCorners * there.at.unit &&
               dot(there.at.normal, there.at.gradient) >= surface::minSlope &&
               !cutOff(m_source, m_source.find(m_cell), farBeyond * there.at.unit);
    }

  private:
    CellSource& m_source;
    const Plane& m_plane;
    std::uint32_t m_cell;
};

/// A point of the section by whichever cell is surface near x.
std::optional<CellPoint> pointNear(CellSource& source, const Plane& plane, const Vec3d& x) {
    const CellValue there = evaluate(source, x, Need::Value);
    if (there.cell == noCell)
        return std::nullopt;
    const CellSection section(source, plane, there.cell);
    const auto out = section.find(x);
    return out && section.holds(*out) ? out : std::nullopt;
}

struct Start {
    Vec3d position;
    std::uint32_t cell = noCell;
};

/// Surfels whose distance to the plane is small for their support, in tree order.
std::vector<Start> surfelsNear(const CellSurface& surface, const Plane& plane) {
    std::vector<Start> out;
    surface.surface().tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        const base::Box3f& box = block.box();
        const Vec3d half = base::cast<double>(box.hi - box.lo) * 0.5;
        const double extent =
            std::abs(plane.normal.x) * half.x + std::abs(plane.normal.y) * half.y + std::abs(plane.normal.z) * half.z;
        const double reach = seedDistance * static_cast<double>(block.maxSupport());
        if (std::abs(plane.distance(base::cast<double>(box.centre()))) > extent + reach)
            return;
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3d p = base::cast<double>(block.position(slot));
            if (std::abs(plane.distance(p)) <= seedDistance * static_cast<double>(block.support(slot)))
                out.push_back({p, surface.labels().cellAt(block, slot)});
        }
    });
    return out;
}

std::vector<CellPoint> findSeeds(const CellSurface& surface, const Plane& plane, const base::Progress& progress) {
    constexpr std::size_t slab = 4096, grain = 64;
    const std::vector<Start> starts = surfelsNear(surface, plane);
    std::vector<CellPoint> found(starts.size());
    for (std::size_t from = 0; from < starts.size(); from += slab) {
        progress.step(0.5 * static_cast<double>(from) / static_cast<double>(starts.size()), "Looking for the section");
        base::parallelChunks(
            std::min(slab, starts.size() - from), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
                CellSource source(surface);
                for (std::size_t i = from + begin; i < from + end; ++i) {
                    const CellSection section(source, plane, starts[i].cell);
                    auto point = section.find(starts[i].position);
                    if (point && !section.holds(*point))
                        point = pointNear(source, plane, point->position);
                    if (point && distance(point->position, starts[i].position) <= seedReach * point->unit)
                        found[i] = *point;
                }
            });
    }
    std::erase_if(found, [](const CellPoint& p) { return p.cell == noCell; });
    return found;
}

using Piece = surface::TracedCurve<CellPoint>;

/// Does b lie before a, on one curve?
bool isBehind(const SectionPoint& b, const SectionPoint& a) {
    return dot(a.along, b.along) > goesOn && dot(b.position - a.position, a.along) < 0;
}

/// Does a curve go on at the beginning of another one? At seams that is one place. Where a crease fades there may be a
/// gap, over which there is surface nearby.
bool isJoint(CellSource& source, const CellPoint& end, const CellPoint& begin) {
    const double far = distance(end.position, begin.position);
    if (far < joined * end.unit)
        return true;
    if (!(far < smoothGap * end.unit))
        return false;
    const CellValue middle = evaluate(source, (end.position + begin.position) / 2, Need::Value);
    return middle.mixed && middle.at.status == surface::Status::Ok && std::abs(middle.at.value) < nearby * end.unit;
}

/// An end of a piece, and where on another one, or on its own beginning, the curve goes on.
struct Joint {
    bool overlaps = false; ///< both have a stretch
    double distance = 0;
    std::size_t end = 0, begin = 0; ///< pieces
    std::size_t first = 0;          ///< of the second one's points that is beyond the first one's end
};

/// The points of pieces, to be found by where they are.
class PieceGrid {
  public:
    explicit PieceGrid(const std::vector<Piece>& pieces) : m_pieces(pieces) {
        for (const Piece& piece : pieces)
            for (const CellPoint& p : piece.points)
                m_side = std::max(m_side, smoothGap * p.unit);
        for (std::uint32_t i = 0; i < pieces.size(); ++i)
            for (std::uint32_t k = 0; !pieces[i].closed && k < pieces[i].points.size(); ++k)
                m_cells.at(cellOf(pieces[i].points[k].position)).push_back({i, k});
    }
    /// fn(piece, point) for points around.
    template <class Fn>
    void forAround(const Vec3d& x, const Fn& fn) const {
        base::forCellsAround(cellOf(x), [&](const base::Cell& cell) {
            if (const std::vector<std::pair<std::uint32_t, std::uint32_t>>* there = m_cells.find(cell))
                for (const auto& [piece, point] : *there)
                    fn(piece, point);
        });
    }

  private:
    base::Cell cellOf(const Vec3d& x) const { return base::cellOf(x, Vec3d(), 1 / m_side); }

    const std::vector<Piece>& m_pieces;
    double m_side = 0;
    base::CellMap<std::vector<std::pair<std::uint32_t, std::uint32_t>>> m_cells;
};

/// Where cells are smooth to each other both have stretches of one curve: does the end lie beside the segment before
/// that point, near its piece's beginning?
bool overlaps(const std::vector<CellPoint>& points, std::size_t k, const CellPoint& end, double& distance) {
    if (k == 0)
        return false;
    const CellPoint &a = points[k - 1], &b = points[k];
    if (!(dot(base::normalized(b.position - a.position), end.along) > goesOn))
        return false;
    const double share = base::shareAlong(a.position, b.position, end.position);
    distance = base::distance(a.position + (b.position - a.position) * share, end.position);
    if (!(share >= 0 && share < 1 && distance < sameCurve * end.unit))
        return false;
    double way = 0;
    for (std::size_t m = 1; m <= k && way < longestOverlap * end.unit; ++m)
        way += base::distance(points[m - 1].position, points[m].position);
    return way < longestOverlap * end.unit;
}

/// Curves of pieces that begin where others end. They run along their tangents, so an end meets a beginning.
std::vector<SectionCurve> join(CellSource& source, const std::vector<Piece>& pieces) {
    const PieceGrid grid(pieces);
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].closed)
            continue;
        const CellPoint& end = pieces[i].points.back();
        const double length = surface::arcLength(pieces[i].points, false);
        grid.forAround(end.position, [&](std::size_t j, std::size_t k) {
            const std::vector<CellPoint>& other = pieces[j].points;
            const double far = distance(end.position, other.front().position);
            double aside = 0;
            if (i == j && !(length > 3 * std::max(far, longestOverlap * end.unit) || (k == 0 && length > 3 * far)))
                return;
            if (k == 0 && isJoint(source, end, other.front()))
                joints.push_back({false, far, i, j, 0});
            else if (overlaps(other, k, end, aside))
                joints.push_back({true, aside, i, j, k});
        });
    }
    std::sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) {
        return std::tie(a.overlaps, a.distance, a.end, a.begin, a.first) <
               std::tie(b.overlaps, b.distance, b.end, b.begin, b.first);
    });
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> next(pieces.size(), none), before(pieces.size(), none), first(pieces.size(), 0);
    for (const Joint& joint : joints)
        if (next[joint.end] == none && before[joint.begin] == none) {
            next[joint.end] = joint.begin;
            before[joint.begin] = joint.end;
            first[joint.begin] = joint.first;
        }
    std::vector<SectionCurve> out;
    std::vector<bool> done(pieces.size());
    const auto follow = [&](std::size_t start) {
        SectionCurve curve;
        std::size_t i = start;
        for (; i != none && !done[i]; i = next[i]) {
            done[i] = true;
            const std::vector<CellPoint>& points = pieces[i].points;
            auto from = points.begin() + static_cast<std::ptrdiff_t>(first[i]);
            while (!curve.points.empty() && points.end() - from > 1 && isBehind(*from, curve.points.back()))
                ++from;
            curve.points.insert(curve.points.end(), from, points.end());
        }
        curve.closed = pieces[start].closed || i == start;
        if (i == start && !pieces[start].closed)
            while (curve.points.size() > 2 && isBehind(curve.points.front(), curve.points.back()))
                curve.points.pop_back();
        if (curve.points.size() > 1)
            out.push_back(std::move(curve));
    };
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (before[i] == none)
            follow(i);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (!done[i])
            follow(i);
    return out;
}

/// Open curves that lie beside others all the way: what a cell that is smooth to others has of their curve.
void dropDoubled(std::vector<SectionCurve>& curves) {
    std::stable_sort(curves.begin(), curves.end(), [](const SectionCurve& a, const SectionCurve& b) {
        return std::pair(b.closed, b.length()) < std::pair(a.closed, a.length());
    });
    surface::TracedLines traced;
    std::vector<SectionCurve> out;
    for (SectionCurve& curve : curves) {
        if (!curve.closed && std::all_of(curve.points.begin(), curve.points.end(),
                                         [&](const SectionPoint& p) { return traced.lineAt(p, sameCurve) >= 0; }))
            continue;
        traced.add(curve.points, curve.closed, out.size());
        out.push_back(std::move(curve));
    }
    curves = std::move(out);
}

/// Shorter than a support, and with an end where no surface ends: beside a crease, by what little a cell is off there.
bool isStub(CellSource& source, const SectionCurve& curve) {
    const double unit = curve.points.front().unit;
    if (curve.closed || curve.length() > unit)
        return false;
    const auto goesOnAt = [&](const SectionPoint& end, double sense) {
        const CellValue there = evaluate(source, end.position + end.along * (sense * ahead * unit), Need::Value);
        return there.mixed && there.at.status == surface::Status::Ok;
    };
    return goesOnAt(curve.points.front(), -1) || goesOnAt(curve.points.back(), 1);
}

} // namespace

std::vector<SectionCurve> findSection(const surface::Surface& surface, const Plane& plane,
                                      const base::Progress& progress, const surface::TraceOptions& options) {
    if (const auto complex = complexes::Complex::of(surface))
        return complexes::findSection(*complex, plane, progress, options);
    const auto cells = CellSurface::of(surface);
    return cells ? findSection(*cells, plane, progress, options)
                 : surface::findSection(surface, plane, progress, options);
}

std::vector<SectionCurve> findSection(const CellSurface& cells, const Plane& plane, const base::Progress& progress,
                                      const surface::TraceOptions& options) {
    std::vector<CellPoint> seeds = findSeeds(cells, plane, progress);
    CellSource source(cells);
    surface::TracedLines traced;
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (i % 64 == 0)
            progress.step(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(seeds.size()),
                          "Following the section");
        if (traced.lineAt(seeds[i], onCurve) >= 0)
            continue;
        Piece piece = surface::traceCurve(CellSection(source, plane, seeds[i].cell), seeds[i], options);
        if (traced.sameAs(piece.points, sameCurve) >= 0)
            continue;
        traced.add(piece.points, piece.closed, pieces.size());
        if (!piece.closed) // where no surfel of the next cell is near the plane
            for (const auto& [end, sense] :
                 {std::pair(piece.points.front(), -1.0), std::pair(piece.points.back(), 1.0)})
                if (const auto next = pointNear(source, plane, end.position + end.along * (sense * ahead * end.unit)))
                    seeds.push_back(*next);
        pieces.push_back(std::move(piece));
    }
    std::vector<SectionCurve> out = join(source, pieces);
    dropDoubled(out);
    std::erase_if(out, [&](const SectionCurve& curve) { return isStub(source, curve); });
    std::stable_sort(out.begin(), out.end(),
                     [](const SectionCurve& a, const SectionCurve& b) { return a.length() > b.length(); });
    return out;
}

} // namespace cells
