// Undoes the shaping of triangles where it made them cut each other (mesh/README 3.14). Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace mesh {

/// What vertices were before they were moved, in their order.
struct VertexPlaces {
    std::vector<base::Vec3d> positions;
    std::vector<base::Vec3f> normals;
};

/// Puts the corners of triangles that cut each other, or have no area, back to where they were, again and again until
/// none is left whose corners have moved. Returns pairs of triangles that cut each other with none of them moved: as
/// where the triangles are others than before. Throws base::Cancelled.
std::vector<std::pair<std::uint32_t, std::uint32_t>> untangle(Mesh& mesh, const VertexPlaces& before, double cell,
                                                              const base::Progress& progress = {});

} // namespace mesh
