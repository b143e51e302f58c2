// Which vertices of a mesh go to the corners of its creases, so that each corner has one (mesh/README 10.2). Internal
// to the room.
#pragma once

#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/seams/crease_vertices.h"

namespace mesh {

/// A corner that a triangle got a vertex for, because its cells meet there.
struct NewCorner {
    CreasePlace place;
    Triangle of;
};

class CornerVertices {
  public:
    /// `faces`: where vertices came to rest on their cells; `vertices`: where they are now, these and perhaps more.
    /// REQUIRES: all outlive it.
    CornerVertices(const Triangulation& triangles, const Mesh& mesh, const std::vector<CreaseVertex>& faces,
                   std::vector<CreaseVertex>& vertices)
        : m_triangles(triangles), m_mesh(mesh), m_faces(faces), m_vertices(vertices) {}

    /// Moves a vertex to a corner, unless one within two edges is there, or at another corner of the same cells.
    bool goIfFree(std::uint32_t v, const CreasePlace& corner);
    /// Where triangles beside each other got a vertex for the same corner, which would cut each other, one that they
    /// share goes there; vertices that went to a corner that triangles know elsewhere come back. Then all has to be cut
    /// anew; false where nothing has moved.
    bool settle(const std::vector<NewCorner>& corners);

  private:
    std::uint32_t goneTo(const CreasePlace& corner, std::uint32_t v) const;
    bool comeBack(const std::vector<NewCorner>& corners);
    bool same(const base::Vec3d& a, const base::Vec3d& b, std::uint32_t v) const;

    const Triangulation& m_triangles;
    const Mesh& m_mesh;
    const std::vector<CreaseVertex>& m_faces;
    std::vector<CreaseVertex>& m_vertices;
};

} // namespace mesh
