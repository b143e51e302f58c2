// How well shaped the triangles of a mesh are: angles, areas, edges.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

struct Shape {
    std::size_t degenerate = 0; ///< without area, to rounding
    /// Of the smallest angles of all triangles, in radians; those without area count as 0.
    double leastAngle = 0, hundredthAngle = 0, medianAngle = 0;
    double area = 0;
    double shortestEdge = 0, longestEdge = 0; ///< zeros without triangles
};

/// In radians; 0 without area.
double smallestAngle(const base::Vec3d& a, const base::Vec3d& b, const base::Vec3d& c);

Shape shapeOf(const Mesh& mesh);

} // namespace mesh
