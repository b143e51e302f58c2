#include "core/mesh/mesh_fans.h"

#include <algorithm>

namespace mesh {

MeshFans::MeshFans(const Mesh& mesh) : m_mesh(mesh), m_first(mesh.positions.size() + 1) {
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            ++m_first[v + 1];
    for (std::size_t v = 1; v < m_first.size(); ++v)
        m_first[v] += m_first[v - 1];
    m_triangles.resize(3 * mesh.triangles.size());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t v : mesh.triangles[t])
            m_triangles[next[v]++] = static_cast<std::uint32_t>(t);
}

std::uint32_t MeshFans::across(std::uint32_t triangle, int corner) const {
    const Triangle& t = m_mesh.triangles[triangle];
    const std::uint32_t a = t[std::size_t(corner)], b = t[std::size_t((corner + 1) % 3)];
    for (const std::uint32_t other : at(a)) {
        const Triangle& o = m_mesh.triangles[other];
        if (other != triangle && (o[0] == b || o[1] == b || o[2] == b))
            return other;
    }
    return none;
}

bool runs(const Triangle& t, std::uint32_t a, std::uint32_t b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

} // namespace mesh
