// The validator: all that can be asked of a mesh, for tests and for `pointclay mesh --check`.
//
//     topology.h    manifold, boundary, pieces, sides, genus
//     shape.h       angles, triangles without area
//     deviation.h   distances to the surface
//     self_intersections.h
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
