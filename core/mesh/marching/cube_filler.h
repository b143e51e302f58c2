// The triangles of some cubes, from the loops around them (mesh/README 3.6). Internal to the room.
#pragma once

#include "core/mesh/marching/fill_loop.h"
#include "core/mesh/mesh.h"

namespace mesh {

/// Triangles of some cubes. Vertices in the middle of loops have numbers of their own, from 0 above `middleBit`, until
/// those of all parts are known.
struct CubePart {
    static constexpr std::uint32_t middleBit = 0x80000000u;
    std::vector<Triangle> triangles;
    std::vector<base::Vec3d> middles;
    std::vector<base::Vec3f> middleNormals;
    std::size_t cubes = 0; ///< that had loops

    /// Of the triangles, whose other corners are the mesh's.
    std::vector<base::Vec3d> centres(const Mesh& mesh) const;
};

class CubeFiller {
  public:
    /// `mesh`: the vertices that loops name. `oriented`: triangles run around its normals, else as their loops do.
    /// REQUIRES: both outlive the filler.
    CubeFiller(const Mesh& mesh, bool oriented, CubePart& out) : m_mesh(mesh), m_oriented(oriented), m_out(out) {}

    /// Adds the triangles of one cube.
    void fill(const std::vector<Loop>& loops);

  private:
    void fill(const Loop& loop);
    void addMiddle();
    double facing() const;
    std::uint32_t name(const Loop& loop, int i) const;

    const Mesh& m_mesh;
    bool m_oriented;
    CubePart& m_out;
    std::vector<base::Vec3d> m_positions;
    std::vector<base::Vec3f> m_normals;
    std::vector<std::array<int, 3>> m_triangles;
};

} // namespace mesh
