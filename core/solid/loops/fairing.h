// Positions and values at the vertices of triangles that vary as little as can be (solid/README 1.3). Inside this room
// only: linear systems are Eigen's, which stays behind its sources.
#pragma once

#include "core/mesh/mesh.h"

#include <Eigen/SparseCore>
#include <span>

namespace solid {

using Columns = Eigen::MatrixXd;

/// Stiffness by cotangents and lumped areas, of lengths in units of `unit`. It is never negative, as a sum of what
/// triangles contribute, nor does it see planes, while weights of single edges, of obtuse angles, may well be below
/// zero: kept above, they would look like curvature, which bends large patches more than the surface around does.
struct Measures {
    Eigen::SparseMatrix<double> stiffness;
    Eigen::VectorXd areas;

    Measures(std::span<const base::Vec3d> positions, std::span<const mesh::Triangle> triangles, double unit);

    /// Of values at each vertex: twice the mean curvature along the outward normal, of positions.
    Columns laplacian(const Columns& values) const {
        return areas.cwiseInverse().asDiagonal() * (stiffness * values).eval();
    }
};

/// Values u of the free vertices, for given ones of the others, of least |grad u|^2 (order 1), |laplace u - bend|^2
/// (order 2) or |grad (laplace u - bend)|^2 (order 3). False where there are none.
bool solve(const Measures& measures, std::span<const std::uint8_t> free, int order, Columns& values,
           const Columns* bend = nullptr);

/// Of each vertex, unit: that of the triangles around, by angle.
std::vector<base::Vec3d> vertexNormals(std::span<const base::Vec3d> positions,
                                       std::span<const mesh::Triangle> triangles);

} // namespace solid
