// The triangles at each vertex of a mesh, in one array: how neighbours across edges are found.
//
// REQUIRES of all functions: edges with at most two triangles.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

class MeshFans {
  public:
    explicit MeshFans(const Mesh& mesh);

    /// Triangles with the vertex as a corner, ascending.
    std::span<const std::uint32_t> at(std::uint32_t vertex) const {
        return {m_triangles.data() + m_first[vertex], m_first[vertex + 1] - m_first[vertex]};
    }
    static constexpr std::uint32_t none = 0xffffffffu;
    /// The other triangle at the edge after the triangle's `corner`, or none.
    std::uint32_t across(std::uint32_t triangle, int corner) const;

  private:
    const Mesh& m_mesh;
    std::vector<std::uint32_t> m_first, m_triangles;
};

/// Does the triangle run from a to b? REQUIRES: both are corners of it.
bool runs(const Triangle& t, std::uint32_t a, std::uint32_t b);

} // namespace mesh
