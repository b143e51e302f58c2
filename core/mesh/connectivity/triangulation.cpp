#include "core/mesh/connectivity/triangulation.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace mesh {

Triangulation::Triangulation(std::span<const Triangle> triangles, std::size_t vertices)
    : m_faces(triangles.size()), m_faceOf(vertices, none) {
    for (std::uint32_t f = 0; f < triangles.size(); ++f)
        if (isProper(triangles[f]))
            setFace(f, triangles[f]);
    link();
}

void Triangulation::setFace(std::uint32_t face, const Triangle& corners) {
    m_faces[face].corners = corners;
    for (const std::uint32_t v : corners)
        m_faceOf[v] = face;
}

/// Sides by their lower ends; those of one vertex, a handful, by the higher ones: sides at one edge stand together.
void Triangulation::link() {
    constexpr std::size_t grain = 8192;
    struct Use {
        std::uint32_t high, side;
    };
    const auto ends = [&](const Side& s) { return std::minmax({from(s), to(s)}); };
    std::vector<std::uint32_t> first(m_faceOf.size() + 1);
    forSides([&](const Side& s) { ++first[ends(s).first + 1]; });
    for (std::size_t v = 1; v < first.size(); ++v)
        first[v] += first[v - 1];
    std::vector<Use> uses(first.back());
    std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
    forSides([&](const Side& s) { uses[fill[ends(s).first]++] = {ends(s).second, pack(s)}; });
    base::parallelFor(m_faceOf.size(), grain, [&](std::size_t v) {
        const auto begin = uses.begin() + first[v], end = uses.begin() + first[v + 1];
        std::sort(begin, end,
                  [](const Use& a, const Use& b) { return a.high != b.high ? a.high < b.high : a.side < b.side; });
        for (auto at = begin; at != end;) {
            const auto cycle = at;
            while (++at != end && at->high == cycle->high)
                m_faces[at[-1].side >> 2].next[at[-1].side & 3] = at->side;
            m_faces[at[-1].side >> 2].next[at[-1].side & 3] = cycle->side;
        }
    });
}

std::size_t Triangulation::facesAtEdge(const Side& s) const {
    std::size_t out = 1;
    for (Side at = next(s); at != s; at = next(at))
        ++out;
    return out;
}

bool Triangulation::isFirst(const Side& s) const {
    for (Side at = next(s); at != s; at = next(at))
        if (pack(at) < pack(s))
            return false;
    return true;
}

void Triangulation::oneRing(std::uint32_t vertex, std::vector<std::uint32_t>& faces) const {
    faces.clear();
    const std::uint32_t first = m_faceOf[vertex];
    if (first == none)
        return;
    faces.push_back(first);
    const auto add = [&](std::uint32_t face) { faces.push_back(face); };
    const int corner = cornerOf(first, vertex);
    if (!turn(vertex, {first, (corner + 1) % 3}, add).exists())
        return;
    std::reverse(faces.begin(), faces.end());
    turn(vertex, {first, (corner + 2) % 3}, add);
}

std::array<Side, 2> Triangulation::boundarySides(std::uint32_t vertex) const {
    const std::uint32_t first = m_faceOf[vertex];
    if (first == none)
        return {};
    const auto pass = [](std::uint32_t) {};
    const int corner = cornerOf(first, vertex);
    const Side one = turn(vertex, {first, (corner + 1) % 3}, pass);
    return one.exists() ? std::array{one, turn(vertex, {first, (corner + 2) % 3}, pass)} : std::array<Side, 2>{};
}

void Triangulation::neighbours(std::uint32_t vertex, std::vector<std::uint32_t>& out) const {
    std::vector<std::uint32_t> faces;
    oneRing(vertex, faces);
    out.clear();
    for (const std::uint32_t f : faces)
        for (const std::uint32_t v : m_faces[f].corners)
            if (v != vertex && std::find(out.begin(), out.end(), v) == out.end())
                out.push_back(v);
}

Side Triangulation::sideBetween(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> faces;
    oneRing(a, faces);
    for (const std::uint32_t f : faces) {
        const Triangle& t = m_faces[f].corners;
        if (t[0] == b || t[1] == b || t[2] == b)
            return {f, 3 - cornerOf(f, a) - cornerOf(f, b)};
    }
    return {};
}

} // namespace mesh
