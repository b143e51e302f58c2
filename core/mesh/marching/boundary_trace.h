// Finds where the surface ends inside a face of the grid (mesh/README 3.4). Internal to the room.
//
// From a loose crossing we follow the curve {f = 0} in the plane of the face until the off-centre value passes its
// limit, the definition breaks down, or the curve leaves the face. An end by the limit is a boundary point of the
// surface (surface/README 5.3); both cubes beside the face share it.
#pragma once

#include "core/mesh/marching/grid_face.h"
#include "core/mesh/mesh.h"

namespace mesh {

/// A crossing that has no partner in a face.
struct LooseEnd {
    std::uint32_t node = 0; ///< rank of the face's lowest node
    int axis = 0;
    GridFace face;
    int index = 0; ///< of the crossing in the face

    std::uint32_t crossing() const { return face.crossing[static_cast<std::size_t>(index)]; }
};

/// All loose ends of the grid, in the order of faces.
std::vector<LooseEnd> looseEnds(const SurfaceGrid& grid);

enum class TraceEnd : std::uint8_t { Limit, Fold, Left };

struct TracedEnd {
    TraceEnd end = TraceEnd::Fold;
    int side = 0; ///< of the face, where the trace left it
    base::Vec3d position;
    base::Vec3f normal;
};

/// Throws base::Cancelled.
std::vector<TracedEnd> trace(const CrossingGrid& grid, std::span<const LooseEnd> ends,
                             const base::Progress& progress = {});

} // namespace mesh
