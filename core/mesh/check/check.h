// The validator: everything one can ask about a mesh (mesh/README 6), for tests and for `pointclay mesh --check`.
//
//     topology.h              manifold, boundary, pieces, sides, genus
//     shape.h                 angles, triangles without area
//     deviation.h             distances to the surface
//     self_intersections.h    pairs of triangles that cut each other
#pragma once

#include "core/mesh/check/deviation.h"
#include "core/mesh/check/shape.h"
#include "core/mesh/check/topology.h"

namespace mesh {

struct Report {
    Topology topology;
    Shape shape;
    Deviation vertices, faces;
    std::size_t selfIntersections = 0; ///< pairs of triangles
};

/// Throws base::Cancelled.
Report check(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress = {});

} // namespace mesh
