#include "core/mesh/delaunay/delaunay_refine.h"

#include "core/mesh/check/shape.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/curves/boundary.h"

#include <algorithm>
#include <utility>

namespace mesh {

using base::Vec3d;

/// Cosine: flips soon mend what a new vertex bends.
static constexpr double insertFacing = 0.5;

DelaunayRefinement::DelaunayRefinement(SurfaceTriangulation& mesh, const FaceDemand& demand, KeptClosed* closed)
    : m_mesh(mesh), m_demand(demand), m_closed(closed) {}

/// On the boundary, or beside a face that is held: never flipped, and halved where a point comes too near.
bool DelaunayRefinement::isProtected(const Side& s) const {
    const Side other = m_mesh.across(s);
    return !other.exists() || held(s.face) || held(other.face);
}

bool DelaunayRefinement::allows(std::span<const Triangle> made, std::span<const std::uint32_t> instead) const {
    return !m_closed || m_closed->allows(made, instead);
}

bool DelaunayRefinement::fails(std::uint32_t face) {
    const Triangle& t = m_mesh.corners(face);
    const Ball& ball = m_facets[face].ball;
    const auto [a, b, c] = m_mesh.cornersOf(t);
    return ball.radius > m_demand.size(ball.centre) || smallestAngle(a, b, c) < m_demand.leastAngle || isFar(t, ball);
}

/// By the ball's centre above the face and by f at the face's own, which may be the larger distance where the surface
/// is bumpy.
bool DelaunayRefinement::isFar(const Triangle& t, const Ball& ball) {
    const auto [a, b, c] = m_mesh.cornersOf(t);
    if (ball.onSurface && std::abs(dot(ball.centre - a, m_mesh.faceNormal(t))) > m_demand.distance)
        return true;
    constexpr double margin = 0.98; // for what one evaluation leaves out
    return m_mesh.height((a + b + c) / 3, m_mesh.surfaceNormal(t)) > margin * m_demand.distance;
}

void DelaunayRefinement::touch(std::uint32_t face, const Ball& ball) {
    m_facets.resize(m_mesh.faceCount());
    if (m_closed)
        m_closed->update(face);
    Facet& facet = m_facets[face];
    facet.ball = ball;
    ++facet.version;
    m_open.push_back(face);
    if (!facet.touched)
        m_touched.push_back(face);
    facet.touched = true;
}

void DelaunayRefinement::touchOneRing(std::uint32_t vertex) {
    std::vector<std::uint32_t> faces;
    m_mesh.oneRing(vertex, faces);
    for (const std::uint32_t f : faces)
        touch(f, m_mesh.ball(m_mesh.corners(f)));
}

void DelaunayRefinement::judgeTouched() {
    for (const std::uint32_t f : m_touched) {
        Facet& facet = m_facets[f];
        facet.touched = false;
        if (facet.ball.radius > (facet.ball.onSurface ? m_demand.floor : m_demand.foldFloor) && !held(f) && fails(f))
            m_bad.push({facet.ball.radius, f, facet.version});
    }
    m_touched.clear();
}

/// Flips until no side can be improved. Balls that are not quite a plane's could send flips round in circles; after
/// many only those go on that make the smallest angle larger, which comes to an end.
void DelaunayRefinement::settle(const base::Progress& progress) {
    const std::size_t many = 100 * (m_open.size() + 100);
    for (std::size_t i = 0; !m_open.empty(); ++i) {
        if (i % 4096 == 4095)
            progress.step(1 - double(m_open.size()) / double(m_open.size() + i), "Flipping");
        const std::uint32_t f = m_open.back();
        m_open.pop_back();
        for (int k = 0; k < 3; ++k)
            if (improve({f, k}, i < many))
                break;
    }
}

/// Would faces face like the surface as well as those that they replace, or at least within `good`, and all run
/// one way?
bool DelaunayRefinement::fit(std::span<const Triangle> faces, std::span<const Triangle> was, double good) const {
    const Vec3d up = m_mesh.surfaceNormal(was.front());
    const auto facing = [&](const Triangle& t) {
        const Vec3d normal = m_mesh.surfaceNormal(t);
        return dot(m_mesh.faceNormal(t), dot(normal, up) < 0 ? -normal : normal);
    };
    const auto least = [&](std::span<const Triangle> all) { // 0 where they run both ways
        const double first = facing(all.front());
        double out = std::abs(first);
        for (const Triangle& t : all)
            out = std::min(out, std::max(0.0, first < 0 ? -facing(t) : facing(t)));
        return out;
    };
    const double after = least(faces);
    return after > 0 && after >= std::min(good, least(was));
}

/// Flips a side that is not Delaunay. Where balls do not agree with themselves, as at folds, the smallest angle
/// decides: no flip is undone.
bool DelaunayRefinement::improve(const Side& s, bool byBalls) {
    if (isProtected(s))
        return false;
    const std::uint32_t p = m_mesh.apex(s), q = m_mesh.apex(m_mesh.across(s)), f = s.face, g = m_mesh.across(s).face;
    const auto& at = m_mesh.positions;
    if (!m_facets[f].ball.holds(at[q]) && !m_facets[g].ball.holds(at[p]))
        return false;
    m_mesh.align(s);
    const std::uint32_t a = m_mesh.from(s), b = m_mesh.to(s);
    constexpr double wellFacing = 0.8;
    const Triangle first{p, a, q}, second{q, b, p}, was{p, a, b}, other{q, b, a};
    if (!fit(std::array{first, second}, std::array{was, other}, wellFacing))
        return false;
    const Ball one = m_mesh.ball(first), two = m_mesh.ball(second);
    if (!byBalls || one.holds(at[b]) || two.holds(at[a])) {
        const auto least = [&](const Triangle& t) { return smallestAngle(at[t[0]], at[t[1]], at[t[2]]); };
        constexpr double better = 1e-9;
        if (std::min(least(first), least(second)) <= std::min(least(was), least(other)) + better)
            return false;
    }
    if (!allows(std::array{first, second}, std::array{f, g}) || !m_mesh.flip(s))
        return false;
    touch(f, one);
    touch(g, two);
    return true;
}

/// Walks from face to face towards a point.
DelaunayRefinement::Location DelaunayRefinement::locate(std::uint32_t face, const Vec3d& x) const {
    constexpr int mostSteps = 64;
    Location out;
    std::uint32_t from = Triangulation::none;
    for (int step = 0; step < mostSteps; ++step) {
        const auto [a, b, c] = m_mesh.cornersOf(m_mesh.corners(face));
        const Vec3d w = cross(b - a, c - a);
        const double area = lengthSq(w);
        out.weights = {dot(cross(c - b, x - b), w) / area, dot(cross(a - c, x - c), w) / area,
                       dot(cross(b - a, x - a), w) / area};
        const int k = static_cast<int>(std::min_element(out.weights.begin(), out.weights.end()) - out.weights.begin());
        out.side = {face, k};
        out.found = true;
        if (!(out.weights[std::size_t(k)] < 0))
            return out;
        const Side other = m_mesh.across(out.side);
        out.outside = isProtected(out.side);
        if (out.outside || other.face == from) // beyond the boundary, or over the side between two faces
            return out;
        from = face;
        face = other.face;
    }
    out.found = false;
    return out;
}

bool DelaunayRefinement::inBall(const Side& s, const Vec3d& x) const {
    const Vec3d a = m_mesh.positions[m_mesh.from(s)], b = m_mesh.positions[m_mesh.to(s)];
    return dot(a - x, b - x) < 0 && distance(a, b) > 2 * m_demand.floor;
}

/// A protected side near the face whose smallest ball holds the point.
Side DelaunayRefinement::encroached(std::uint32_t face, const Vec3d& x) const {
    for (int k = 0; k < 3; ++k) {
        const Side s{face, k}, other = m_mesh.across(s);
        if (isProtected(s)) {
            if (inBall(s, x))
                return s;
            continue;
        }
        for (int j = 0; j < 3; ++j)
            if (const Side t{other.face, j}; isProtected(t) && inBall(t, x))
                return t;
    }
    return {};
}

/// A point near the middle of a side, inside or on the surface's boundary curve; loops of folds are straight where
/// there is none, as are sides of held faces.
std::optional<SurfacePoint> DelaunayRefinement::middleOf(const Side& s, VertexKind& kind) {
    const std::uint32_t a = m_mesh.from(s), b = m_mesh.to(s);
    const Vec3d middle = (m_mesh.positions[a] + m_mesh.positions[b]) * 0.5, normal = m_mesh.surfaceNormal({a, b, b});
    const double near = 0.25 * distance(m_mesh.positions[a], m_mesh.positions[b]);
    const bool boundary = m_mesh.onBoundary(s);
    if (boundary && m_mesh.kinds[a] == VertexKind::Limit && m_mesh.kinds[b] == VertexKind::Limit) {
        const auto found = findBoundaryPoint(m_mesh.surface(), middle, {base::cast<float>(normal)});
        if (found.ok() && distance(found.point.position, middle) < near) {
            kind = VertexKind::Limit;
            return SurfacePoint{found.point.position, base::cast<float>(found.point.normal)};
        }
    }
    kind = boundary ? VertexKind::Fold : VertexKind::Inner;
    if (const auto root = m_mesh.root(middle, normal, near, m_mesh.facingOf({a, b, b})))
        return SurfacePoint{middle + normal * root->t, root->normal};
    return isProtected(s) ? std::optional(SurfacePoint{middle, base::cast<float>(normal)}) : std::nullopt;
}

/// A vertex in the middle of a side; false where the side is short enough.
bool DelaunayRefinement::halve(const Side& s) {
    const double floor = m_demand.floor;
    if (distance(m_mesh.positions[m_mesh.from(s)], m_mesh.positions[m_mesh.to(s)]) <= 2 * floor)
        return false;
    VertexKind kind = VertexKind::Inner;
    const auto point = middleOf(s, kind);
    if (!point)
        return false;
    for (const Side& side : {s, m_mesh.across(s)})
        if (side.exists() && distance(m_mesh.positions[m_mesh.apex(side)], point->position) < 0.5 * floor)
            return false;
    const std::uint32_t v = m_mesh.addVertex(*point, kind);
    if (!splitSide(s, v))
        return false;
    touchOneRing(v);
    return true;
}

/// A point of the surface over a face, near x.
std::optional<SurfacePoint> DelaunayRefinement::pointOver(std::uint32_t face, const Vec3d& x) {
    const Triangle& t = m_mesh.corners(face);
    const auto [a, b, c] = m_mesh.cornersOf(t);
    const Vec3d along = m_mesh.faceNormal(t);
    const double reach = 0.5 * std::max({distance(a, b), distance(b, c), distance(c, a)});
    const double above = dot(x - a, along);
    const Vec3d start = std::abs(above) > reach ? x - along * above : x;
    const auto root = m_mesh.root(start, along, reach, m_mesh.facingOf(t));
    if (!root)
        return std::nullopt;
    return SurfacePoint{start + along * root->t, root->normal};
}

/// Makes the centre of a face's ball a vertex; false where the triangulation is too bent to tell where it lies.
bool DelaunayRefinement::insertCentre(const Bad& bad) {
    const Vec3d centre = m_facets[bad.face].ball.centre;
    const Location where = locate(bad.face, centre);
    constexpr double beside = -0.5; // over a side between two faces, weights are a little negative
    if (!where.found || (!where.outside && where.least() < beside))
        return false;
    const Side near = where.outside ? where.side : encroached(where.side.face, centre);
    if (near.exists())
        return halve(near);
    const auto point = pointOver(where.side.face, centre);
    constexpr double empty = 0.3; // of the ball's radius: nearer is no Delaunay triangulation
    const double nearest = std::max(empty * bad.radius, 0.5 * m_demand.floor);
    if (!point)
        return false;
    for (const Vec3d& corner : m_mesh.cornersOf(m_mesh.corners(where.side.face)))
        if (distance(corner, point->position) < nearest)
            return false;
    const std::uint32_t v = m_mesh.addVertex(*point, VertexKind::Inner);
    if (!split(where, v))
        return false;
    touchOneRing(v);
    return true;
}

/// The face, or its side where that is near and the face alone would be bent.
bool DelaunayRefinement::split(const Location& where, std::uint32_t vertex) {
    constexpr double onSide = 0.03, nearSide = 0.3;
    const bool border = isProtected(where.side);
    return ((border || where.least() >= onSide) && splitFace(where.side.face, vertex)) ||
           (!border && where.least() < nearSide && splitSide(where.side, vertex));
}

/// False, and nothing changed, where the faces would not fit.
bool DelaunayRefinement::splitFace(std::uint32_t face, std::uint32_t vertex) {
    const Triangle t = m_mesh.corners(face);
    const std::array parts{Triangle{t[0], t[1], vertex}, Triangle{t[1], t[2], vertex}, Triangle{t[2], t[0], vertex}};
    if (!fit(parts, {&t, 1}, insertFacing) || !allows(parts, {&face, 1}))
        return false;
    m_mesh.splitFace(face, vertex);
    return true;
}

/// The same.
bool DelaunayRefinement::splitSide(const Side& s, std::uint32_t vertex) {
    std::vector<Triangle> parts;
    std::vector<std::uint32_t> faces;
    for (const Side& side : {s, m_mesh.across(s)}) {
        if (!side.exists())
            continue;
        const std::uint32_t p = m_mesh.apex(side), a = m_mesh.from(side), b = m_mesh.to(side);
        const Triangle was{p, a, b};
        const std::array two{Triangle{p, a, vertex}, Triangle{p, vertex, b}};
        if (!held(side.face) && !fit(two, {&was, 1}, insertFacing))
            return false;
        parts.insert(parts.end(), two.begin(), two.end());
        faces.push_back(side.face);
    }
    if (!allows(parts, faces))
        return false;
    const std::uint32_t next = m_mesh.faceCount(); // their second halves, in the same order
    m_mesh.splitSide(s, vertex);
    for (std::uint32_t i = 0; m_closed && i < faces.size(); ++i)
        m_closed->inherit(next + i, faces[i]);
    return true;
}

/// What is left where nothing else fits: faces of a closed surface cannot be left out.
bool DelaunayRefinement::insertMiddle(std::uint32_t face) {
    const auto [a, b, c] = m_mesh.cornersOf(m_mesh.corners(face));
    const auto point = pointOver(face, (a + b + c) / 3);
    if (!point || std::min({distance(point->position, a), distance(point->position, b), distance(point->position, c)}) <
                      0.5 * m_demand.floor)
        return false;
    const std::uint32_t v = m_mesh.addVertex(*point, VertexKind::Inner);
    if (!splitFace(face, v))
        return false;
    touchOneRing(v);
    return true;
}

/// False, and nothing changed, where no new vertex fits.
bool DelaunayRefinement::refine(const Bad& bad) {
    if (!insertCentre(bad) && !halve(longestSide(bad.face)) && !(m_closed && insertMiddle(bad.face)))
        return false;
    settle();
    judgeTouched();
    if (m_mesh.alive(bad.face) && m_facets[bad.face].version == bad.version)
        m_bad.push(bad);
    return true;
}

Side DelaunayRefinement::longestSide(std::uint32_t face) const {
    const auto [a, b, c] = m_mesh.cornersOf(m_mesh.corners(face));
    const std::array<double, 3> sides{distanceSq(b, c), distanceSq(c, a), distanceSq(a, b)};
    return {face, static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin())};
}

void DelaunayRefinement::run(const base::Progress& progress) {
    for (std::uint32_t f = 0; f < m_mesh.faceCount(); ++f)
        if (m_mesh.alive(f))
            touch(f, m_mesh.ball(m_mesh.corners(f)));
    settle(process::part(progress, 0, 0.2));
    judgeTouched();
    const base::Progress refining = process::part(progress, 0.2, 1);
    std::vector<Bad> stuck; // of a closed mesh: tried again, as long as others change around them
    bool changed = false;
    for (std::size_t i = 0;; ++i) {
        if (m_bad.empty() && m_closed && std::exchange(changed, false))
            for (const Bad& bad : std::exchange(stuck, {}))
                m_bad.push(bad);
        if (m_bad.empty())
            break;
        if (i % 256 == 0) {
            const double done = double(m_mesh.faceCount());
            refining.step(done / (done + 2 * double(m_bad.size())), "Triangulating");
        }
        const Bad next = m_bad.top();
        m_bad.pop();
        if (!m_mesh.alive(next.face) || m_facets[next.face].version != next.version)
            continue;
        if (refine(next))
            changed = true;
        else if (m_closed)
            stuck.push_back(next);
    }
}

std::vector<bool> DelaunayRefinement::failing() {
    std::vector<bool> out(m_mesh.faceCount(), false);
    for (std::uint32_t f = 0; f < out.size(); ++f)
        out[f] = m_mesh.alive(f) && fails(f);
    return out;
}

} // namespace mesh
