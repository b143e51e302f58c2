// Tessellation: triangles per second, of a piece of the model, whose size keeps a run below a second.
#include "app/bench/naive/naive_march.h"
#include "app/bench/workload.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/spacing_sample.h"

namespace bench {

namespace {

constexpr std::size_t mostMarched = 50'000, mostTriangulated = 5'000;

/// The surfels nearest to a place, or the whole of a model that has no more.
surface::Surface pieceOf(Scene& scene, std::size_t most) {
    const tree::SurfelTree& model = scene.surface().tree();
    if (model.size() <= most)
        return scene.surface();
    std::vector<tree::Neighbour> near;
    model.nearest(scene.places(1)[0].position, most, near);
    surfel::SurfelList list;
    list.layout = model.layout();
    const std::vector<std::uint32_t> words(model.layout()->words());
    for (const tree::Neighbour& n : near)
        list.append(n.block->surfel(n.slot), words);
    return {tree::SurfelTree::build(list), scene.surface().definition()};
}

/// Vertices stay on the grid's edges, as those of the naive way do.
Run marching(Scene& scene) {
    return [surface = pieceOf(scene, mostMarched)] {
        mesh::MarchingOptions options;
        options.relax = false;
        mesh::MarchingReport report;
        const mesh::Mesh made = mesh::marchingCubes(surface, options, report);
        keep(made);
        return made.triangles.size();
    };
}

Run naiveMarching(Scene& scene) {
    if (!NaiveSurface::speaks(scene.surface()))
        return {};
    const surface::Surface piece = pieceOf(scene, mostMarched);
    return [naive = std::make_shared<NaiveSurface>(piece),
            cell = static_cast<double>(process::typicalSpacing(piece.tree()))] {
        const NaiveMesh made = naiveMarch(*naive, cell);
        keep(made);
        return made.triangles.size();
    };
}

/// Triangles about as large as the spacing.
Run triangulating(Scene& scene) {
    return [surface = pieceOf(scene, mostTriangulated)] {
        mesh::DelaunayReport report;
        const mesh::Mesh made = mesh::restrictedDelaunay(surface, {}, report);
        keep(made);
        return made.triangles.size();
    };
}

} // namespace

std::vector<Workload> meshWorkloads() {
    return {
        {"mesh-marching-cubes", "triangle", "marching cubes of a piece of 50k surfels, cells of one spacing",
         "grid near the surfels, nanoflann, Eigen double, corner signs", marching, naiveMarching},
        {"mesh-delaunay", "triangle",
         "restricted Delaunay triangulation of a piece of 5k surfels, sizes of one spacing", "", triangulating,
         nullptr},
    };
}

} // namespace bench
