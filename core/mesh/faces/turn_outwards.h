// Closed pieces of faces that are inside out: which of them have to be turned so that what they enclose is inside
// (mesh/README 8.1).
//
// A piece encloses a volume, whose sign tells which way it is turned. The file knows which pieces are holes in others:
// what lies inside of another piece keeps its side relative to that. Only outermost pieces are judged, and take along
// what is inside of them.
#pragma once

#include "core/base/vec.h"
#include "core/mesh/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mesh {

/// What is known of pieces of faces, all of one piece turned alike.
struct FacePieces {
    std::vector<std::uint32_t> of; ///< of each triangle: its piece, from 0
    std::vector<double> borders; ///< of each piece: length of its edges that hold an odd number of its faces; infinity
                                 ///< where it has no two sides
};

enum class Facing : std::uint8_t {
    Open,     ///< more than small holes (borders^2 above 1 % of the area), or next to nothing enclosed: only the file
              ///< can know the side
    Outwards, ///< encloses a volume, and looks away from it, or into it where it is a hole in another one
    Inwards   ///< the contrary: to be turned
};

/// For each piece. `areas`: of each triangle. In parallel, the same at any thread count.
std::vector<Facing> facingOf(const FacePieces& pieces, std::span<const Triangle> triangles,
                             std::span<const double> areas, std::span<const base::Vec3f> positions);

} // namespace mesh
