#include "core/mesh/seams/keep_creases.h"

#include "core/mesh/check/shape.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/seams/crease_tidy.h"
#include "core/process/estimation/part_progress.h"

namespace mesh {

bool keepCreases(Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    const auto cells = cells::CellSurface::of(surface);
    if (!cells || mesh.triangles.empty())
        return false;
    CutMesh cut = cutAtCreases(*cells, std::move(mesh), process::part(progress, 0, 0.8));
    progress.step(0.8, "shaping triangles beside creases");
    tidyCreases(cut);
    untangle(cut.mesh, cut.before, shapeOf(cut.mesh).longestEdge, process::part(progress, 0.9, 1));
    mesh = std::move(cut.mesh);
    mesh.colours.clear();
    mesh.masks.clear();
    mesh.extra.clear();
    mesh.layout = surfel::AttributeLayout::none();
    dropUnused(mesh);
    takeAttributes(mesh, surface);
    return true;
}

} // namespace mesh
