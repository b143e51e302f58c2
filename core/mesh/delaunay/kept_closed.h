// What keeps a closed mesh closed and free of cuts while it is coarsened and refined (mesh/README 4.8). Internal to the
// room.
//
// Edits keep the topology (2.3), and none may make faces cut others. Faces that span what is no surface, or what f does
// not tell, are *held*: they stay as the cubes made them, and their sides to others are protected as a boundary is,
// except that they may be halved.
#pragma once

#include "core/mesh/delaunay/cut_guard.h"

namespace mesh {

class KeptClosed {
  public:
    /// `held`: by face. `cell`: as the guard wants it. REQUIRES: the triangulation outlives this.
    KeptClosed(const SurfaceTriangulation& mesh, std::vector<bool> held, double cell)
        : m_mesh(mesh), m_guard(mesh, cell), m_held(std::move(held)) {}

    bool held(std::uint32_t face) const { return face < m_held.size() && m_held[face]; }
    /// A face that was made from another one.
    void inherit(std::uint32_t face, std::uint32_t from) {
        if (m_held.size() <= face)
            m_held.resize(face + 1, false);
        m_held[face] = held(from);
    }
    bool allows(std::span<const Triangle> made, std::span<const std::uint32_t> instead) {
        return m_guard.allows(made, instead);
    }
    void update(std::uint32_t face) { m_guard.update(face); }
    /// `ring`: the vertex' faces.
    bool mayCollapse(std::span<const std::uint32_t> ring, std::uint32_t vertex, std::uint32_t into);

  private:
    const SurfaceTriangulation& m_mesh;
    CutGuard m_guard;
    std::vector<bool> m_held;
};

} // namespace mesh
