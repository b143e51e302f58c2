// A patch of a complex as triangles (mesh/README 11): marching cubes of its own points, carried on past the boundary,
// cut off there. Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/complexes/complex.h"
#include "core/mesh/mesh.h"

namespace mesh {

struct PatchMesh {
    static constexpr std::uint32_t inside = ~0u;

    Mesh mesh;                     ///< positions, normals, kinds, triangles
    std::vector<std::uint32_t> on; ///< of each vertex: the curve or point of the complex that it lies on, or `inside`
    double cell = 0;               ///< of the cubes
};

/// All boundary vertices lie on cells of the patch's boundary, where it has one. REQUIRES: a patch with points of its
/// own. Throws base::Error where they make no surface, base::Cancelled.
/// `shift`: of the cubes, in cells.
PatchMesh meshOfPatch(const complexes::Complex& complex, std::uint32_t patch, double cell, const base::Vec3d& shift,
                      const base::Progress& progress);

} // namespace mesh
