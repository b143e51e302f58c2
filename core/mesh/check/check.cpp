#include "core/mesh/check/check.h"

#include "core/mesh/check/self_intersections.h"
#include "core/process/estimation/part_progress.h"

namespace mesh {

Report check(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    Report out;
    progress.step(0, "Checking");
    out.topology = topologyOf(mesh.triangles, mesh.positions.size(), mesh.kinds);
    progress.step(0.1, "Checking");
    out.shape = shapeOf(mesh);
    out.vertices = vertexDeviation(mesh, surface, process::part(progress, 0.2, 0.4));
    out.faces = faceDeviation(mesh, surface, process::part(progress, 0.4, 0.8));
    out.selfIntersections = selfIntersections(mesh, process::part(progress, 0.8, 1)).size();
    return out;
}

} // namespace mesh
