#include "core/mesh/seams/corner_vertices.h"

#include <tuple>

namespace mesh {

using base::Vec3d;

namespace {

constexpr std::uint32_t none = Triangulation::none;

/// A vertex that could go to a corner which several of its triangles got a vertex for.
struct Move {
    std::size_t shared; ///< further ones of its triangles
    double far;
    std::uint32_t vertex, corner;
};

} // namespace

/// Within a thousandth of how far a vertex would have to go?
bool CornerVertices::same(const Vec3d& a, const Vec3d& b, std::uint32_t v) const {
    constexpr double part = 1e-3, least = 1e-12;
    return base::distance(a, b) < part * base::distance(a, m_faces[v].position) + least;
}

/// A vertex within two edges that has gone to a corner already, or to another one of its cells.
std::uint32_t CornerVertices::goneTo(const CreasePlace& corner, std::uint32_t v) const {
    const auto gone = [&](std::uint32_t w) {
        const CreaseVertex& other = m_vertices[w];
        return w != v && other.atCorner() &&
               (other.cells.sameAs(corner.cells) || same(corner.position, other.position, v));
    };
    std::vector<std::uint32_t> ring, second;
    m_triangles.neighbours(v, ring);
    for (const std::uint32_t w : ring) {
        if (gone(w))
            return w;
        m_triangles.neighbours(w, second);
        if (const auto found = std::find_if(second.begin(), second.end(), gone); found != second.end())
            return *found;
    }
    return none;
}

bool CornerVertices::goIfFree(std::uint32_t v, const CreasePlace& corner) {
    const bool free = goneTo(corner, v) == none;
    if (free)
        m_vertices[v].goTo(corner);
    return free;
}

/// Triangles know better where a corner is than a vertex that happens to be near.
bool CornerVertices::comeBack(const std::vector<NewCorner>& corners) {
    bool any = false;
    for (const NewCorner& each : corners)
        for (const std::uint32_t v : each.of) {
            const std::uint32_t gone = goneTo(each.place, v);
            if (gone == none || !same(each.place.position, m_vertices[gone].position, v))
                continue;
            m_vertices[gone] = m_faces[gone];
            any = true;
        }
    return any;
}

bool CornerVertices::settle(const std::vector<NewCorner>& corners) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> of; // a vertex, a corner of one of its triangles
    for (std::uint32_t i = 0; i < corners.size(); ++i)
        for (const std::uint32_t v : corners[i].of)
            if (movable(m_mesh, v) && !m_vertices[v].atCorner())
                of.emplace_back(v, i);
    std::sort(of.begin(), of.end());
    std::vector<Move> moves;
    for (std::size_t i = 0; i < of.size(); ++i) {
        const auto [v, corner] = of[i];
        const Vec3d& place = corners[corner].place.position;
        std::size_t shared = 0;
        for (std::size_t j = i + 1; j < of.size() && of[j].first == v; ++j)
            shared += same(place, corners[of[j].second].place.position, v) ? 1 : 0;
        if (shared > 0)
            moves.push_back({shared, base::distance(place, m_faces[v].position), v, corner});
    }
    std::sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) {
        return std::tuple(b.shared, a.far, a.vertex, a.corner) < std::tuple(a.shared, b.far, b.vertex, b.corner);
    });
    bool any = comeBack(corners);
    for (const Move& each : moves)
        any |= goIfFree(each.vertex, corners[each.corner].place);
    return any;
}

} // namespace mesh
