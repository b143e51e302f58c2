#include "core/mesh/delaunay/triangle_net.h"

#include "core/mesh/edges.h"

#include <algorithm>
#include <utility>

namespace mesh {

TriangleNet::TriangleNet(std::span<const Triangle> triangles, std::size_t vertices)
    : m_faces(triangles.size()), m_faceOf(vertices, none) {
    for (std::uint32_t f = 0; f < triangles.size(); ++f)
        setFace(f, triangles[f]);
    forEdges(edgeUses(triangles), [&](std::span<const EdgeUse> uses) {
        const auto side = [](const EdgeUse& use) { // from corner k to the next lies opposite to the third
            return Side{use.face(), static_cast<int>((use.corner + 2) % 3)};
        };
        if (uses.size() == 2)
            tie(side(uses[0]), side(uses[1]));
    });
}

void TriangleNet::tie(const Side& s, const Side& other) {
    if (s.exists())
        m_faces[s.face].across[std::size_t(s.k)] = pack(other);
    if (other.exists())
        m_faces[other.face].across[std::size_t(other.k)] = pack(s);
}

void TriangleNet::setFace(std::uint32_t face, const Triangle& corners) {
    m_faces[face].corners = corners;
    for (const std::uint32_t v : corners)
        m_faceOf[v] = face;
}

std::uint32_t TriangleNet::addFace() {
    m_faces.emplace_back();
    return faceCount() - 1;
}

std::uint32_t TriangleNet::addVertex() {
    m_faceOf.push_back(none);
    return static_cast<std::uint32_t>(m_faceOf.size()) - 1;
}

int TriangleNet::cornerOf(std::uint32_t face, std::uint32_t vertex) const {
    const Triangle& t = m_faces[face].corners;
    return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
}

void TriangleNet::turnOver(std::uint32_t face) {
    Face& f = m_faces[face];
    const Side second = unpack(f.across[1]), third = unpack(f.across[2]);
    std::swap(f.corners[1], f.corners[2]);
    tie({face, 1}, third);
    tie({face, 2}, second);
}

void TriangleNet::align(const Side& s) {
    const Side other = across(s);
    if (from(other) == from(s))
        turnOver(other.face);
}

/// Appends the faces about the vertex beyond a side of it, until the rim or until the side is met again; the last side.
Side TriangleNet::walk(std::uint32_t vertex, Side s, std::vector<std::uint32_t>& out) const {
    const Side start = s;
    for (;;) {
        const Side other = across(s);
        if (!other.exists() || other.face == start.face)
            return other;
        out.push_back(other.face);
        const int corner = cornerOf(other.face, vertex);
        s = {other.face, 3 - corner - other.k};
    }
}

void TriangleNet::fan(std::uint32_t vertex, std::vector<std::uint32_t>& out) const {
    out.clear();
    const std::uint32_t first = m_faceOf[vertex];
    if (first == none)
        return;
    out.push_back(first);
    const int corner = cornerOf(first, vertex);
    if (walk(vertex, {first, (corner + 1) % 3}, out).exists())
        return;
    std::reverse(out.begin(), out.end());
    walk(vertex, {first, (corner + 2) % 3}, out);
}

bool TriangleNet::onRim(std::uint32_t vertex) const {
    std::vector<std::uint32_t> faces;
    fan(vertex, faces);
    return std::any_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
        const int corner = cornerOf(f, vertex);
        return onRim(Side{f, (corner + 1) % 3}) || onRim(Side{f, (corner + 2) % 3});
    });
}

void TriangleNet::neighbours(std::uint32_t vertex, std::vector<std::uint32_t>& out) const {
    std::vector<std::uint32_t> faces;
    fan(vertex, faces);
    out.clear();
    for (const std::uint32_t f : faces)
        for (const std::uint32_t v : m_faces[f].corners)
            if (v != vertex && std::find(out.begin(), out.end(), v) == out.end())
                out.push_back(v);
}

Side TriangleNet::sideBetween(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> faces;
    fan(a, faces);
    for (const std::uint32_t f : faces) {
        const Triangle& t = m_faces[f].corners;
        if (t[0] == b || t[1] == b || t[2] == b)
            return {f, 3 - cornerOf(f, a) - cornerOf(f, b)};
    }
    return {};
}

bool TriangleNet::joined(std::uint32_t a, std::uint32_t b) const {
    return sideBetween(a, b).exists();
}

bool TriangleNet::flip(const Side& s) {
    if (onRim(s))
        return false;
    align(s);
    const Side other = across(s);
    const std::uint32_t p = apex(s), a = from(s), b = to(s), q = apex(other);
    if (p == q || joined(p, q))
        return false;
    const std::uint32_t f = s.face, g = other.face;
    const Side pa = across({f, (s.k + 2) % 3}), bp = across({f, (s.k + 1) % 3});
    const Side aq = across({g, (other.k + 1) % 3}), qb = across({g, (other.k + 2) % 3});
    setFace(f, {p, a, q});
    setFace(g, {q, b, p});
    tie({f, 0}, aq);
    tie({f, 2}, pa);
    tie({g, 0}, bp);
    tie({g, 2}, qb);
    tie({f, 1}, {g, 1});
    return true;
}

void TriangleNet::splitFace(std::uint32_t face, std::uint32_t vertex) {
    const auto [a, b, c] = m_faces[face].corners;
    const Side bc = across({face, 0}), ca = across({face, 1});
    const std::uint32_t g = addFace(), h = addFace();
    setFace(face, {a, b, vertex});
    setFace(g, {b, c, vertex});
    setFace(h, {c, a, vertex});
    tie({g, 2}, bc);
    tie({h, 2}, ca);
    tie({face, 0}, {g, 1});
    tie({g, 0}, {h, 1});
    tie({h, 0}, {face, 1});
}

void TriangleNet::splitSide(const Side& s, std::uint32_t vertex) {
    if (!onRim(s))
        align(s);
    const Side other = across(s);
    const std::uint32_t p = apex(s), a = from(s), b = to(s);
    const Side bp = across({s.face, (s.k + 1) % 3}), pa = across({s.face, (s.k + 2) % 3});
    const std::uint32_t f = s.face, f2 = addFace();
    setFace(f, {p, a, vertex});
    setFace(f2, {p, vertex, b});
    tie({f, 2}, pa);
    tie({f2, 1}, bp);
    tie({f, 1}, {f2, 2});
    tie({f, 0}, {});
    tie({f2, 0}, {});
    if (!other.exists())
        return;
    const std::uint32_t q = apex(other), g = other.face, g2 = addFace();
    const Side aq = across({g, (other.k + 1) % 3}), qb = across({g, (other.k + 2) % 3});
    setFace(g, {q, b, vertex});
    setFace(g2, {q, vertex, a});
    tie({g, 2}, qb);
    tie({g2, 1}, aq);
    tie({g, 1}, {g2, 2});
    tie({g, 0}, {f2, 0});
    tie({g2, 0}, {f, 0});
}

/// The link condition (Dey, Edelsbrunner, Guha & Nekhayev, Topology preserving edge contraction, 1999).
bool TriangleNet::mayCollapse(std::uint32_t vertex, std::uint32_t into, const Side& side) const {
    const bool rim = onRim(side);
    if (!rim && onRim(vertex) && onRim(into))
        return false;
    std::vector<std::uint32_t> here, there;
    neighbours(vertex, here);
    neighbours(into, there);
    std::size_t common = 0;
    for (const std::uint32_t v : here)
        common += static_cast<std::size_t>(std::count(there.begin(), there.end(), v));
    if (common != (rim ? 1u : 2u))
        return false;
    for (const Side& s : {side, across(side)}) {
        if (!s.exists())
            continue;
        const bool first = onRim(Side{s.face, (s.k + 1) % 3}), second = onRim(Side{s.face, (s.k + 2) % 3});
        std::vector<std::uint32_t> around;
        neighbours(apex(s), around);
        if ((first && second) || (around.size() <= 3 && !onRim(apex(s))))
            return false;
    }
    return true;
}

bool TriangleNet::collapse(std::uint32_t vertex, std::uint32_t into) {
    const Side side = sideBetween(vertex, into);
    if (!side.exists() || !mayCollapse(vertex, into, side))
        return false;
    std::vector<std::uint32_t> faces;
    fan(vertex, faces);
    const Side other = across(side);
    for (const std::uint32_t f : faces)
        if (f != side.face && f != other.face)
            m_faces[f].corners[std::size_t(cornerOf(f, vertex))] = into;
    for (const Side& s : {side, other}) {
        if (!s.exists())
            continue;
        const std::uint32_t peak = apex(s);
        const Side first = across({s.face, (s.k + 1) % 3}), second = across({s.face, (s.k + 2) % 3});
        tie(first, second);
        tie(second, first);
        m_faces[s.face] = {};
        m_faceOf[peak] = m_faceOf[into] = first.exists() ? first.face : second.face;
    }
    m_faceOf[vertex] = none;
    return true;
}

void TriangleNet::removeEar(std::uint32_t face) {
    const Triangle corners = m_faces[face].corners;
    for (int k = 0; k < 3; ++k)
        tie(across({face, k}), {});
    std::array<std::uint32_t, 3> left{none, none, none}; // a face that stays, for each corner
    for (int k = 0; k < 3; ++k)
        if (const Side other = across({face, k}); other.exists())
            left[std::size_t((k + 1) % 3)] = left[std::size_t((k + 2) % 3)] = other.face;
    m_faces[face] = {};
    for (std::size_t k = 0; k < 3; ++k)
        m_faceOf[corners[k]] = left[k];
}

} // namespace mesh
