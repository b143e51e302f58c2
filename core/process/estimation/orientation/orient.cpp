// Consistent orientation: the minimum spanning tree of unlikeness over the neighbour graph [Hoppe92],
// with a flip rule (process/README 2.2) that knows the edge between the two points.
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/orientation/orientation_pieces.h"
#include "core/process/estimation/part_progress.h"

namespace process {

bool orient(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
            const base::Progress& progress, Sides given) {
    if (cloud.size() < 2)
        return true;
    OrientationTrees trees(cloud, links, normals, part(progress, 0, 0.5));
    joinPieces(cloud, normals, trees, part(progress, 0.5, 0.7));
    const bool sided = !trees.hasSeam(part(progress, 0.7, 0.8));
    trees.takeSigns(given, {}, part(progress, 0.8, 1));
    return sided;
}

} // namespace process
