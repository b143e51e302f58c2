#include "core/mesh/check.h"

#include "core/process/part_progress.h"

namespace mesh {

Report check(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    Report out;
    progress.step(0, "Checking");
    out.topology = topologyOf(mesh.triangles, mesh.positions.size(), mesh.kinds);
    progress.step(0.1, "Checking");
    out.shape = shapeOf(mesh);
    out.vertices = vertexDeviation(mesh, surface, process::part(progress, 0.2, 0.5));
    out.faces = faceDeviation(mesh, surface, process::part(progress, 0.5, 1));
    return out;
}

} // namespace mesh
