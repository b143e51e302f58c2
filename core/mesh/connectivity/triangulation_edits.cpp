#include "core/mesh/connectivity/triangulation.h"

#include <algorithm>
#include <utility>

namespace mesh {

/// Of two sides, or of one that has no other and is on the boundary then.
void Triangulation::tie(const Side& s, const Side& other) {
    const auto set = [&](const Side& at, const Side& next) {
        if (at.exists())
            m_faces[at.face].next[std::size_t(at.k)] = pack(next.exists() ? next : at);
    };
    set(s, other);
    set(other, s);
}

std::uint32_t Triangulation::addFace() {
    m_faces.emplace_back();
    return faceCount() - 1;
}

std::uint32_t Triangulation::addVertex() {
    m_faceOf.push_back(none);
    return static_cast<std::uint32_t>(m_faceOf.size()) - 1;
}

void Triangulation::turnOver(std::uint32_t face) {
    const Side second = across({face, 1}), third = across({face, 2});
    std::swap(m_faces[face].corners[1], m_faces[face].corners[2]);
    tie({face, 1}, third);
    tie({face, 2}, second);
}

void Triangulation::align(const Side& s) {
    const Side other = across(s);
    if (from(other) == from(s))
        turnOver(other.face);
}

bool Triangulation::flip(const Side& s) {
    if (onBoundary(s))
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

void Triangulation::splitFace(std::uint32_t face, std::uint32_t vertex) {
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

void Triangulation::splitSide(const Side& s, std::uint32_t vertex) {
    if (!onBoundary(s))
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

/// The link condition [Dey99].
bool Triangulation::mayCollapse(std::uint32_t vertex, std::uint32_t into, const Side& side) const {
    const bool boundary = onBoundary(side);
    if (!boundary && onBoundary(vertex) && onBoundary(into))
        return false;
    std::vector<std::uint32_t> here, there;
    neighbours(vertex, here);
    neighbours(into, there);
    std::size_t common = 0;
    for (const std::uint32_t v : here)
        common += static_cast<std::size_t>(std::count(there.begin(), there.end(), v));
    if (common != (boundary ? 1u : 2u))
        return false;
    for (const Side& s : {side, across(side)}) {
        if (!s.exists())
            continue;
        const bool first = onBoundary(Side{s.face, (s.k + 1) % 3}), second = onBoundary(Side{s.face, (s.k + 2) % 3});
        std::vector<std::uint32_t> around;
        neighbours(apex(s), around);
        if ((first && second) || (around.size() <= 3 && !onBoundary(apex(s))))
            return false;
    }
    return true;
}

bool Triangulation::collapse(std::uint32_t vertex, std::uint32_t into) {
    const Side side = sideBetween(vertex, into);
    if (!side.exists() || !mayCollapse(vertex, into, side))
        return false;
    std::vector<std::uint32_t> faces;
    oneRing(vertex, faces);
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
        m_faces[s.face] = {};
        m_faceOf[peak] = m_faceOf[into] = first.exists() ? first.face : second.face;
    }
    m_faceOf[vertex] = none;
    return true;
}

void Triangulation::removeEar(std::uint32_t face) {
    const Triangle corners = m_faces[face].corners;
    std::array<std::uint32_t, 3> left{none, none, none}; // a face that stays, for each corner
    for (int k = 0; k < 3; ++k)
        if (const Side other = across({face, k}); other.exists()) {
            left[std::size_t((k + 1) % 3)] = left[std::size_t((k + 2) % 3)] = other.face;
            tie(other, {});
        }
    m_faces[face] = {};
    for (std::size_t k = 0; k < 3; ++k)
        m_faceOf[corners[k]] = left[k];
}

} // namespace mesh
