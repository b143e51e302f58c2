// Keeps a triangulation free of faces that cut each other while it is edited (mesh/README 4.8). Internal to the room.
//
// Faces lie in the cubes of a grid that their boxes touch. Before an edit the faces that it would make are compared, by
// exact predicates, with those around and with each other:
//
//     CutGuard guard(triangulation, cell);
//     if (guard.allows(made, instead)) { ...edit...; guard.update(face) for each face that it changed or made }
//
// Cost: of a question that of the faces in a few cubes, whatever the size of the model. One thread at a time.
#pragma once

#include "core/base/box.h"
#include "core/mesh/delaunay/surface_triangulation.h"

#include <unordered_map>

namespace mesh {

class CutGuard {
  public:
    /// `cell`: side of a cube, in model units; a few edges long. REQUIRES: the triangulation outlives the guard.
    CutGuard(const SurfaceTriangulation& mesh, double cell);

    /// Would faces with these corners have an area, and cut neither each other nor any face but those that they stand
    /// in for? Vertices must have their positions; nothing is changed.
    bool allows(std::span<const Triangle> made, std::span<const std::uint32_t> instead);
    /// A face was made, changed or removed.
    void update(std::uint32_t face);

  private:
    using Cube = std::array<std::int64_t, 3>;
    Cube cubeOf(const base::Vec3d& x) const;
    base::Box3d boxOf(const Triangle& t) const;
    template <class Fn>
    void forCubes(const base::Box3d& box, const Fn& fn) const;
    void enter(std::uint32_t face);
    void leave(std::uint32_t face);
    bool cutsAny(const Triangle& t, std::span<const std::uint32_t> but);

    const SurfaceTriangulation& m_mesh;
    double m_cell;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cubes; ///< by key: faces
    std::vector<base::Box3d> m_boxes;                                      ///< by face; empty where it is gone
    std::vector<std::uint32_t> m_seen; ///< by face: the last question it was part of
    std::uint32_t m_question = 0;
};

} // namespace mesh
