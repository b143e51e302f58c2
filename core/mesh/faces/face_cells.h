// Faces that meet three and more at an edge: which of them bound the solid, and which lie in it (mesh/README 8.1).
//
// Boxes that share a wall, a part with ribs inside, pieces that touch in an edge: such complexes of faces divide space
// into cells. Around each edge neighbours are those next to each other by angle, so that cells are found by joining
// sides of faces, whichever way these are turned [Zhou16]. A ray finds the cell outside. How often the faces turn
// around the other cells, as they are given, tells which of these are solid; where that contradicts itself, all are.
#pragma once

#include "core/mesh/faces/face_sides.h"

#include <cstdint>

namespace mesh {

/// Distinct triangles, and what is known of each.
struct CellFaces {
    std::span<const Triangle> triangles;
    std::span<const base::Vec3d> normals; ///< zero where it has no area
    std::span<const double> areas;
    std::span<const std::int8_t> given; ///< it came more often its own way round (1), the other way (-1), neither (0)
    std::span<const base::Vec3f> positions;
};

enum class FaceRole : std::uint8_t {
    Skin,   ///< stays as it is: a side of the solid, a sheet outside of it, or of a complex that is no matter of cells
    Turned, ///< a side of the solid that faces into it, where others do not
    Inside  ///< with the solid on both sides
};

/// Of each triangle; empty where no edge has three faces and more. `sides`: of these triangles, sorted.
std::vector<FaceRole> rolesOf(const CellFaces& faces, std::span<const FaceSide> sides, const Places& places);

} // namespace mesh
