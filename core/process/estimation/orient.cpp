// Consistent orientation: the minimum spanning tree of unlikeness over the neighbour graph [Hoppe92],
// with a flip rule (process/README 2.2) that knows the edge between the two points.
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/orientation_trees.h"
#include "core/process/estimation/part_progress.h"

namespace process {

/// Kruskal's minimum spanning trees of the neighbour graph, with the flips along their edges.
static base::ParitySets spanningTrees(const NormalLinks& links, std::size_t points, const base::Progress& progress) {
    base::ParitySets trees(points);
    for (std::size_t k = 0; k < links.order.size(); ++k) {
        if (k % 131072 == 0)
            progress.step(static_cast<double>(k) / static_cast<double>(links.order.size()), "Orienting normals");
        const std::uint32_t e = links.order[k];
        trees.relate(links.edges[e].a, links.edges[e].b, links.likenesses[e].flip);
    }
    return trees;
}

bool orient(const Cloud& cloud, std::span<base::Vec3f> normals, int neighbours, const base::Progress& progress,
            Sides given) {
    if (cloud.size() < 2)
        return true;
    const NormalLinks links = normalLinks(cloud, normals, neighbours, part(progress, 0, 0.7));
    base::ParitySets trees = spanningTrees(links, cloud.size(), part(progress, 0.7, 0.9));
    const bool sided = !hasSeam(trees, links, cloud.size());
    takeSigns(trees, cloud, normals, given, part(progress, 0.9, 1));
    return sided;
}

} // namespace process
