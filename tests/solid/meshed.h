// The kind of a model's mesh.
#pragma once

#include "core/mesh/check/topology.h"
#include "core/mesh/marching/marching_cubes.h"

namespace test {

inline mesh::Topology meshed(const surface::Surface& surface) {
    mesh::MarchingReport report;
    const mesh::Mesh mesh = mesh::marchingCubes(surface, {}, report);
    return mesh::topologyOf(mesh.triangles, mesh.positions.size(), mesh.kinds);
}

} // namespace test
