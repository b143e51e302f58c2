#include "core/solid/loops/plane_cap.h"

#include "core/base/cancel_scope.h"
#include "core/base/mat3.h"
#include "core/base/parallel.h"
#include "core/base/segment.h"
#include "core/cells/labels.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/combine.h"
#include "core/solid/loops/patch_surfels.h"
#include "core/solid/map_places.h"
#include "core/solid/segment_runs.h"
#include "core/solid/spacing_beside.h"

#include <algorithm>
#include <cmath>

namespace solid {

using base::Point2;
using base::Vec3d;

namespace {

constexpr double leastTurn = 0.14; // 8 degrees: less is as flat as surfaces are

/// Twice the area that the loop goes round, as a vector: the side that it is counter-clockwise about.
Vec3d areaOf(const Loop& loop) {
    Vec3d out;
    for (std::size_t i = 0; i < loop.size(); ++i)
        out += cross(loop.points[i].position - loop.middle, loop.points[(i + 1) % loop.size()].position - loop.middle);
    return out;
}

Vec3d upOf(const Pose& plane) {
    return plane.turn * Vec3d{0, 0, 1};
}

/// The plane that places leave least, with its z axis on the side of `up`.
Pose planeThrough(std::span<const Vec3d> places, const Vec3d& up) {
    Vec3d middle;
    for (const Vec3d& x : places)
        middle += x / static_cast<double>(places.size());
    base::Mat3d spread;
    for (const Vec3d& x : places)
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                spread[i][k] += (x - middle)[static_cast<std::size_t>(i)] * (x - middle)[static_cast<std::size_t>(k)];
    const Vec3d normal = base::symmetricEigen(spread).vector[0];
    return poseAlong(middle, dot(normal, up) < 0 ? -normal : normal);
}

Pose meanPlane(const Loop& loop) {
    std::vector<Vec3d> places;
    for (const LoopPoint& p : loop.points)
        places.push_back(p.position);
    return planeThrough(places, areaOf(loop));
}

bool liesIn(const Pose& plane, const Loop& loop) {
    constexpr double most = 3, mean = 0.6; // spacings: as ragged as rims of points by chance
    double sum = 0;
    for (const LoopPoint& p : loop.points) {
        const double off = plane.local(p.position).z / p.spacing;
        sum += off * off;
        if (std::abs(off) > most)
            return false;
    }
    return sum <= mean * mean * static_cast<double>(loop.size());
}

/// Surfels within two spacings of the loop, once for each of its places: fn(place, position).
template <class Fn>
void forBeside(const surface::Surface& surface, const Loop& loop, const Fn& fn) {
    constexpr double beside = 2;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto reach = static_cast<float>(beside * loop.points[i].spacing);
        const base::Vec3f x = base::cast<float>(loop.points[i].position), by{reach, reach, reach};
        surface.tree().forBlocksInSupport({x - by, x + by}, [&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (distance(block.position(slot), x) < reach)
                    fn(i, base::cast<double>(block.position(slot)));
        });
    }
}

/// What cut the model off here has no surfels beyond: the plane through the outermost ones of each stretch of the loop,
/// moved to the outermost of all, above (`side` 1) or below (-1). Nothing where that is more than 1.5 spacings.
std::optional<Pose> planeAtSurfels(const surface::Surface& surface, const Loop& loop, Pose plane, double side) {
    constexpr std::size_t stretch = 4; // places
    constexpr int rounds = 3;
    constexpr double most = 1.5; // spacings
    const Pose first = plane;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Vec3d> outermost((loop.size() + stretch - 1) / stretch, loop.middle);
        std::vector<double> heights(outermost.size(), -std::numeric_limits<double>::infinity());
        forBeside(surface, loop, [&](std::size_t i, const Vec3d& x) {
            if (const double z = side * plane.local(x).z; z > heights[i / stretch])
                heights[i / stretch] = z, outermost[i / stretch] = x;
        });
        plane = planeThrough(outermost, upOf(plane));
    }
    double out = -std::numeric_limits<double>::infinity();
    forBeside(surface, loop, [&](std::size_t, const Vec3d& x) { out = std::max(out, side * plane.local(x).z); });
    plane.middle += plane.turn * Vec3d{0, 0, side * out};
    for (const LoopPoint& p : loop.points)
        if (!(std::abs(plane.local(p.position).z - first.local(p.position).z) <=
              most * p.spacing)) // or no surfel is near
            return {};
    return plane;
}

/// The same without an end: beyond its boundary the surface goes on to where a cap meets it.
surface::Surface endless(const surface::Surface& surface) {
    surface::SurfaceDefinition definition = surface.definition();
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return {surface.tree(), definition};
}

enum class Sense { Convex, Concave, Neither };

/// What nearly all places of the loop say: convex above 0, concave below.
template <class Says>
Sense saidBy(const Loop& loop, const Says& says) {
    constexpr double nearly = 0.02; // of the places may say nothing
    std::size_t convex = 0, concave = 0;
    for (const LoopPoint& p : loop.points) {
        const int said = says(p);
        convex += said > 0 ? 1 : 0, concave += said < 0 ? 1 : 0;
    }
    const auto most = static_cast<std::size_t>(nearly * static_cast<double>(loop.size()));
    return convex + most >= loop.size()    ? Sense::Convex
           : concave + most >= loop.size() ? Sense::Concave
                                           : Sense::Neither;
}

/// How it meets the plane.
Sense senseOf(const Vec3d& up, const Loop& loop) {
    return saidBy(loop, [&](const LoopPoint& p) {
        return length(p.normal - up) > leastTurn ? (dot(p.outward, up) > 0 ? 1 : -1) : 0;
    });
}

/// The same by the side to which the surface would go on, where all of it leaves the plane.
Sense clearSenseOf(const Vec3d& up, const Loop& loop) {
    return saidBy(loop, [&](const LoopPoint& p) {
        const double along = dot(p.outward, up);
        return along > leastTurn ? 1 : along < -leastTurn ? -1 : 0;
    });
}

std::vector<Point2> rimOf(const Pose& plane, const Loop& loop) {
    std::vector<Point2> out;
    for (const LoopPoint& p : loop.points) {
        const Vec3d q = plane.local(p.position);
        out.push_back({q.x, q.y});
    }
    return out;
}

/// The planes of some caps beside their loops.
class CapsSide : public Side {
  public:
    /// `sense`: 1 where what lies above the planes is solid, -1 for below.
    CapsSide(std::span<const PlaneCap* const> caps, double sense)
        : m_sense(sense), m_pieces(piecesOf(caps)), m_runs(boxesOf(m_pieces)) {
        for (const Piece& piece : m_pieces) {
            const Vec3d by = Vec3d{1, 1, 1} * (reach * piece.spacing);
            m_box.extend(piece.from - by), m_box.extend(piece.from + by);
        }
    }
    SideValue at(const Vec3d& x) const override {
        const auto foot = [&](std::size_t k) { return base::nearestOnSegment(m_pieces[k].from, m_pieces[k].to, x); };
        const std::size_t k = m_runs.nearest(x, [&](std::size_t i) { return distanceSq(foot(i), x); });
        const Piece& piece = m_pieces[k];
        if (distance(foot(k), x) > reach * piece.spacing)
            return {1, {}, false};
        const Vec3d up = piece.cap->pose.turn * Vec3d{0, 0, -m_sense};
        return {dot(up, x - piece.cap->pose.middle), up, true};
    }
    bool meets(const base::Box3d& box) const override { return m_box.overlaps(box); }
    SideFoot foot(const Vec3d& x) const override {
        const SideValue here = at(x);
        return {x - here.gradient * here.value, here.value, here.gradient, here.near};
    }

  private:
    static constexpr double reach = 8; ///< spacings: as far as a seam is looked for from twice as far as partners are
    struct Piece {
        Vec3d from, to;
        double spacing;
        const PlaneCap* cap;
    };
    static std::vector<Piece> piecesOf(std::span<const PlaneCap* const> caps) {
        std::vector<Piece> out;
        for (const PlaneCap* cap : caps)
            for (std::size_t i = 0, loop = 0, first = 0; i < cap->loop.size(); ++i) {
                const bool last = i + 1 == cap->ends[loop];
                const LoopPoint& p = cap->loop.points[i];
                out.push_back({p.position, cap->loop.points[last ? first : i + 1].position, p.spacing, cap});
                if (last)
                    first = cap->ends[loop++];
            }
        return out;
    }
    static std::vector<base::Box3d> boxesOf(std::span<const Piece> pieces) {
        std::vector<base::Box3d> out(pieces.size());
        for (std::size_t k = 0; k < pieces.size(); ++k)
            out[k].extend(pieces[k].from), out[k].extend(pieces[k].to);
        return out;
    }

    double m_sense;
    std::vector<Piece> m_pieces;
    SegmentRuns m_runs;
    base::Box3d m_box;
};

/// Places of a cap: as dense as its loop's nearest points tell, and within the model where that is near. None where
/// they would be too many.
class CapPlaces {
  public:
    CapPlaces(const surface::Surface& surface, PlaneCap& cap)
        : m_cap(cap), m_model(endless(surface)), m_outline(cap.rims), m_spacing(cap.loop) {
        double most = 0, least = std::numeric_limits<double>::infinity();
        for (const LoopPoint& p : cap.loop.points) {
            const Vec3d q = cap.pose.local(p.position);
            m_box.extend(Vec3d{q.x, q.y, 0});
            most = std::max(most, p.spacing), least = std::min(least, p.spacing);
        }
        const Map map{*this,
                      {m_box.lo.x - doubtful * most, m_box.lo.y - doubtful * most},
                      {m_box.hi.x + doubtful * most, m_box.hi.y + doubtful * most}};
        if (areTooMany(map, least))
            return;
        std::vector<Vec3d> places; // u, v, spacing
        forPlaces(map, least, most, [&](double u, double v, double spacing) { places.push_back({u, v, spacing}); });
        std::vector<std::uint8_t> holds(places.size());
        base::parallelFor(places.size(), 64, [&](std::size_t i) {
            holds[i] = isInside({places[i].x, places[i].y}, places[i].z);
        });
        for (std::size_t i = 0; i < places.size(); ++i)
            if (holds[i]) {
                cap.patch.positions.push_back(cap.pose.place({places[i].x, places[i].y, 0}));
                cap.patch.spacings.push_back(places[i].z);
            }
    }

  private:
    static constexpr double doubtful = 1.5; ///< spacings from the loop within which the surface itself tells
    struct Map {
        const CapPlaces& cap;
        Point2 lo, hi;
        double unit(double /*v*/) const { return 1; }
        double spacing(double u, double v) const { return cap.m_spacing.at(cap.m_cap.pose.place({u, v, 0})); }
    };
    /// Loops are round at corners of the model, as boundary curves are: its surface is not.
    bool isInside(const Point2& p, double spacing) const {
        const double by = doubtful * spacing;
        const bool held = m_outline.holds(p);
        if (!m_outline.meets({p.x - by, p.y - by}, {p.x + by, p.y + by}))
            return held;
        const SideValue side = m_model.at(m_cap.pose.place({p.x, p.y, 0}));
        return side.near ? (side.value < 0) == m_cap.convex : held;
    }

    PlaneCap& m_cap;
    SurfaceSide m_model;
    base::Outline m_outline;
    SpacingBeside m_spacing;
    base::Box3d m_box;
};

/// Caps of one sense put on.
surface::Surface put(const surface::Surface& surface, std::span<const PlaneCap* const> caps, bool convex, bool creases,
                     const base::Progress& progress) {
    if (caps.empty())
        return surface;
    PatchSurfels made(surface);
    std::vector<cells::Label> labels;
    for (std::uint32_t k = 0; k < caps.size(); ++k) {
        made.addCap(*caps[k], convex);
        cells::Label label;
        label.cell = label.partner = label.face = k;
        labels.resize(made.surfels().size(), label);
    }
    surfel::SurfelList surfels = made.surfels();
    cells::setLabels(surfels, labels);
    // a floor is joined to what it is the floor of; what ends at a plane is cut off by what lies beyond it
    const CapsSide side(caps, convex ? 1 : -1);
    Operand operand{side, std::move(surfels), std::vector<std::int8_t>(surface.tree().size(), 1), true};
    const Operation operation = convex ? Operation::Difference : Operation::Union;
    return {combine(endless(surface), operand, operation, {creases}, progress).surface.tree(), surface.definition()};
}

} // namespace

std::optional<PlaneCap> PlaneCap::over(const surface::Surface& surface, std::span<const Loop> loops) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    if (!layout.normals || !layout.oriented)
        return {};
    const Loop& outer = loops.front();
    const Pose mean = meanPlane(outer);
    const Sense sense = senseOf(upOf(mean), outer);
    if (sense == Sense::Neither || !liesIn(mean, outer))
        return {};
    const std::optional<Pose> plane = planeAtSurfels(surface, outer, mean, sense == Sense::Convex ? 1 : -1);
    if (!plane)
        return {};
    PlaneCap out{*plane, {}, sense == Sense::Convex, {{}, 0, outer.middle}, {}, {}};
    for (const Loop& loop : loops) {
        out.rims.push_back(rimOf(out.pose, loop));
        out.loop.points.insert(out.loop.points.end(), loop.points.begin(), loop.points.end());
        out.loop.length += loop.length;
        out.ends.push_back(out.loop.size());
    }
    CapPlaces(surface, out);
    if (out.patch.positions.empty())
        return {};
    return out;
}

std::vector<std::optional<std::size_t>> nestedLoops(std::span<const Loop> loops) {
    std::vector<std::optional<std::size_t>> out(loops.size());
    std::vector<std::pair<double, std::size_t>> largestFirst;
    for (std::size_t k = 0; k < loops.size(); ++k)
        if (loops[k].size() > 0)
            largestFirst.emplace_back(-length(areaOf(loops[k])), k);
    std::ranges::sort(largestFirst);
    for (const auto& [size, k] : largestFirst) {
        base::CancelScope::check();
        const Loop& outer = loops[k];
        if (out[k]) // between it and those in it there is nothing
            continue;
        const Pose plane = meanPlane(outer);
        const Vec3d up = upOf(plane);
        const Sense sense = clearSenseOf(up, outer);
        if (sense == Sense::Neither || !liesIn(plane, outer))
            continue;
        const std::vector<Point2> rim = rimOf(plane, outer);
        const base::Outline outline{std::span<const Point2>(rim)};
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const Loop& inner = loops[i];
            if (i == k || inner.size() == 0 || !(dot(areaOf(inner), up) < 0) || !liesIn(plane, inner) ||
                clearSenseOf(up, inner) != sense)
                continue;
            if (std::ranges::all_of(rimOf(plane, inner), [&](const Point2& p) { return outline.holds(p); }))
                out[i] = k; // of several the smallest
        }
    }
    return out;
}

surface::Surface capped(const surface::Surface& surface, std::span<const PlaneCap* const> caps, bool creases,
                        const base::Progress& progress) {
    std::vector<const PlaneCap*> ends, floors;
    for (const PlaneCap* cap : caps)
        (cap->convex ? ends : floors).push_back(cap);
    return put(put(surface, ends, true, creases, process::part(progress, 0, 0.5)), floors, false, creases,
               process::part(progress, 0.5, 1));
}

} // namespace solid
