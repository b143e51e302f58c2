#include "core/mesh/marching/cut_mesh.h"

#include "core/base/parallel.h"
#include "core/mesh/cell_size.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/marching/cube_filler.h"
#include "core/mesh/marching/cube_sizes.h"
#include "core/mesh/marching/cube_tree.h"
#include "core/mesh/marching/graded_cubes.h"
#include "core/mesh/marching/hold_tolerance.h"
#include "core/mesh/marching/thin_walls.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"

#include <algorithm>
#include <optional>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t bricksPerTask = 64;
constexpr double cubesAround = 8; ///< around everything

/// `doubled`: how often, for the largest cubes.
Lattice latticeFor(const surface::Surface& surface, const MarchingOptions& options, double cell, int doubled = 0) {
    Lattice out;
    out.cell = cell;
    if (!(out.cell > 0) || !std::isfinite(out.cell))
        throw base::Error("the model has no spacing to take the cell size from", "", "give a cell size");
    out.turned = options.turned;
    const base::Box3f bounds = surface.tree().bounds().inflated(surface.tree().maxSupport());
    base::Box3d turned;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3f at{corner & 1 ? bounds.hi.x : bounds.lo.x, corner & 2 ? bounds.hi.y : bounds.lo.y,
                       corner & 4 ? bounds.hi.z : bounds.lo.z};
        turned.extend(out.turned * base::cast<double>(at));
    }
    const Vec3d size = turned.size() / out.cell;
    const double margin = std::ldexp(cubesAround, doubled);
    if (std::max({size.x, size.y, size.z}) + 4 * margin > Lattice::extent)
        throw base::Error("the cells are too small for a model of this size", "", "choose larger cells");
    const Vec3d around = Vec3d{margin, margin, margin} + options.shift;
    out.origin = transposed(out.turned) * (turned.lo - around * out.cell);
    return out;
}

/// Traces loose ends; edges beside those that end in nothing are walked again with care, twice at most.
template <class Grid>
LooseEnds settleEnds(Grid& grid, std::vector<TracedEnd>& boundary, MarchingReport& report,
                     const base::Progress& progress) {
    constexpr int rounds = 2;
    for (int round = 0;; ++round) {
        std::vector<LooseEnd> ends = looseEnds(grid);
        const std::vector<TracedEnd> traced = trace(grid, ends, process::part(progress, 0.8, 0.85));
        std::vector<typename Grid::EdgeName> doubtful;
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (traced[i].end != TraceEnd::Limit)
                for (const auto& edge : grid.edgesOf(ends[i].face))
                    doubtful.push_back(edge);
        if (round < rounds && !doubtful.empty() && grid.reconsider(doubtful, progress))
            continue;
        LooseEnds out(grid, std::move(ends), traced);
        for (const std::uint32_t end : out.boundary()) {
            boundary.push_back(traced[end]);
            ++(traced[end].end == TraceEnd::Limit ? report.limitEnds : report.foldEnds);
        }
        return out;
    }
}

void addVertices(const CrossingGrid& grid, std::span<const TracedEnd> boundary, Mesh& out) {
    for (const Crossing& each : grid.crossings()) {
        out.positions.push_back(each.position);
        out.normals.push_back(each.normal);
        out.kinds.push_back(each.bridge ? VertexKind::Bridge : VertexKind::Inner);
    }
    for (const TracedEnd& end : boundary) {
        out.positions.push_back(end.position);
        out.normals.push_back(end.normal);
        out.kinds.push_back(end.end == TraceEnd::Limit ? VertexKind::Limit : VertexKind::Fold);
    }
}

/// Cubes of the grid's own size, but those that `covered` says are part of larger ones.
template <class Covered>
std::vector<CubePart> fillCubes(const SurfaceGrid& grid, const LooseEnds& loose, const Mesh& mesh,
                                const Covered& covered) {
    const SparseSet& nodes = grid.nodes();
    std::vector<CubePart> parts(base::chunkCount(nodes.bricks().size(), bricksPerTask));
    const auto fill = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        CubeFiller filler(mesh, grid.traits().oriented, parts[chunk]);
        std::vector<Loop> loops;
        for (std::size_t b = begin; b < end; ++b) {
            const Neighbourhood around(nodes, static_cast<std::uint32_t>(b));
            nodes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& p, std::uint32_t) {
                if (covered(p))
                    return;
                loopsOf(grid, loose, around, p, loops);
                filler.fill(loops);
            });
        }
    };
    base::parallelChunks(nodes.bricks().size(), bricksPerTask, fill);
    return parts;
}

/// The larger ones.
std::vector<CubePart> fillLargeCubes(const CubeTree& tree, int level, bool oriented, const Mesh& mesh) {
    constexpr std::size_t cubesPerTask = 1024;
    const std::vector<GridIndex>& places = tree.large()[std::size_t(level)];
    std::vector<CubePart> parts(base::chunkCount(places.size(), cubesPerTask));
    base::parallelChunks(places.size(), cubesPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        CubeFiller filler(mesh, oriented, parts[chunk]);
        std::vector<Loop> loops;
        for (std::size_t i = begin; i < end; ++i) {
            tree.loopsOf(places[i], level, loops);
            filler.fill(loops);
        }
    });
    return parts;
}

/// The middles of the triangles of some larger cubes.
struct CubeCentres {
    std::vector<Vec3d> centres;
    std::vector<GridIndex> cubes; ///< by centre
};

std::vector<CubeCentres> centresOf(const SurfaceGrid& grid, const CubeTree& tree, int level, const Mesh& mesh) {
    constexpr std::size_t cubesPerTask = 1024;
    const std::vector<GridIndex>& places = tree.large()[std::size_t(level)];
    std::vector<CubeCentres> out(base::chunkCount(places.size(), cubesPerTask));
    base::parallelChunks(places.size(), cubesPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        CubePart part;
        CubeFiller filler(mesh, grid.traits().oriented, part);
        std::vector<Loop> loops;
        for (std::size_t i = begin; i < end; ++i) {
            tree.loopsOf(places[i], level, loops);
            filler.fill(loops);
            out[chunk].cubes.resize(part.triangles.size(), places[i]);
        }
        out[chunk].centres = part.centres(mesh);
    });
    return out;
}

/// Larger cubes with a triangle whose middle is further from the surface than the tolerance, or has none near, are not
/// to be one any more; returns whether there were any.
bool takeApart(const SurfaceGrid& grid, const CubeTree& tree, const Mesh& mesh, double tolerance,
               std::vector<SparseSet>& apart) {
    bool any = false;
    for (int level = 1; level < static_cast<int>(tree.large().size()); ++level) {
        SparseSet& known = apart[std::size_t(level)];
        std::vector<BrickBits> bits;
        for (const SparseSet::Brick& brick : known.bricks())
            bits.push_back({brick.key, brick.mask});
        const std::size_t before = bits.size();
        for (const CubeCentres& part : centresOf(grid, tree, level, mesh)) {
            const std::vector<std::uint8_t> far = farTriangles(grid.surface(), part.centres, tolerance);
            for (std::size_t t = 0; t < far.size(); ++t)
                if (far[t])
                    bits.push_back(bitsOf(part.cubes[t]));
        }
        any = any || bits.size() > before;
        known = SparseSet(std::move(bits));
    }
    return any;
}

void addParts(const std::vector<CubePart>& parts, Mesh& out, MarchingReport& report) {
    for (const CubePart& part : parts) {
        const auto first = static_cast<std::uint32_t>(out.positions.size());
        out.positions.insert(out.positions.end(), part.middles.begin(), part.middles.end());
        out.normals.insert(out.normals.end(), part.middleNormals.begin(), part.middleNormals.end());
        out.kinds.resize(out.positions.size(), VertexKind::Inner);
        report.cubes += part.cubes;
        for (Triangle t : part.triangles) {
            for (std::uint32_t& v : t)
                if (v & CubePart::middleBit)
                    v = first + (v & ~CubePart::middleBit);
            out.triangles.push_back(t);
        }
    }
}

/// Of a level.
std::vector<CubePart> fillGradedCubes(const GradedGrid& grid, const LooseEnds& loose, int level, const Mesh& mesh) {
    const SparseSet& cubes = grid.cubes(level);
    std::vector<CubePart> parts(base::chunkCount(cubes.bricks().size(), bricksPerTask));
    base::parallelChunks(
        cubes.bricks().size(), bricksPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            CubeFiller filler(mesh, grid.traits().oriented, parts[chunk]);
            std::vector<Loop> loops;
            for (std::size_t b = begin; b < end; ++b)
                cubes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& place, std::uint32_t) {
                    loopsOf(grid, loose, {place, level}, loops);
                    filler.fill(loops);
                });
        });
    return parts;
}

/// Cubes with more than one loop, through whose faces of four these may wind so that their triangles cut each other.
bool addCrowdedCubes(const GradedGrid& grid, std::vector<std::vector<BrickBits>>& halve) {
    const LooseEnds none(grid, {}, {});
    std::vector<Loop> loops;
    bool any = false;
    for (int level = 1; level <= grid.levels().highest(); ++level) {
        const SparseSet& cubes = grid.cubes(level);
        for (std::uint32_t b = 0; b < cubes.bricks().size(); ++b)
            cubes.forMembers(b, [&](const GridIndex& place, std::uint32_t) {
                if (!grid.traits().closed && hasLooseEnd(grid, {place, level}))
                    return; // at a rim
                loopsOf(grid, none, {place, level}, loops);
                if (loops.size() < 2)
                    return;
                halve[std::size_t(level)].push_back(bitsOf(place));
                any = true;
            });
    }
    return any;
}

/// By cubes that are as large as the surfels there are apart.
Mesh gradedMesh(const surface::Surface& surface, const MarchingOptions& options, const CubeSizes& sizes,
                MarchingReport& report, const base::Progress& progress) {
    constexpr int rounds = 4; // of which the first is all that most models need
    const Lattice lattice = latticeFor(surface, options, sizes.cell, sizes.highest);
    report.cell = lattice.cell;
    std::vector<std::vector<BrickBits>> halve = cubesToHalve(surface, lattice, sizes);
    std::optional<GradedGrid> built;
    for (int round = 0; round < rounds; ++round) {
        built.emplace(surface, solidTraits(surface, options), lattice, CubeLevels(halve));
        built->build(process::part(progress, 0.8 - 0.8 / (1 << round), 0.8 - 0.4 / (1 << round)));
        if (!built->traits().sided || !addCrowdedCubes(*built, halve))
            break;
    }
    GradedGrid& grid = *built;
    std::vector<TracedEnd> boundary;
    const LooseEnds loose = settleEnds(grid, boundary, report, progress);
    progress.step(0.85, "filling cubes");
    Mesh out;
    addVertices(grid, boundary, out);
    for (int level = 0; level <= sizes.highest; ++level) {
        const std::size_t before = out.triangles.size();
        addParts(fillGradedCubes(grid, loose, level, out), out, report);
        if (out.triangles.size() > before)
            report.largestCell = std::ldexp(lattice.cell, level);
    }
    return out;
}

Mesh evenMesh(const surface::Surface& surface, const MarchingOptions& options, double cell, MarchingReport& report,
              const base::Progress& progress) {
    const Lattice lattice = latticeFor(surface, options, cell);
    report.cell = lattice.cell;
    SurfaceGrid grid(surface, solidTraits(surface, options), lattice);
    grid.build(process::part(progress, 0, 0.8));
    std::vector<TracedEnd> boundary;
    const LooseEnds loose = settleEnds(grid, boundary, report, progress);
    progress.step(0.85, "filling cubes");
    Mesh out;
    addVertices(grid, boundary, out);
    report.largestCell = lattice.cell;
    if (!(options.adaptive > 0)) {
        addParts(fillCubes(grid, loose, out, [](const GridIndex&) { return false; }), out, report);
        return out;
    }
    std::vector<SparseSet> apart(CubeTree::mostLevels + 1);
    std::optional<CubeTree> found;
    do {
        progress.step(0.9, "joining cubes");
        found.emplace(grid, loose.ends(), options.adaptive, apart);
    } while (takeApart(grid, *found, out, options.adaptive, apart));
    const CubeTree& tree = *found;
    addParts(fillCubes(grid, loose, out, [&](const GridIndex& p) { return tree.covered(p); }), out, report);
    for (int level = 1; level < static_cast<int>(tree.large().size()); ++level) {
        addParts(fillLargeCubes(tree, level, grid.traits().oriented, out), out, report);
        if (!tree.large()[std::size_t(level)].empty())
            report.largestCell = lattice.cell * (1 << level);
    }
    dropUnused(out);
    return out;
}

} // namespace

SurfaceTraits solidTraits(const surface::Surface& surface, const MarchingOptions& options) {
    SurfaceTraits out(surface);
    out.closed = out.closed && options.solid;
    out.sided = out.sided && options.solid;
    return out;
}

Mesh cutMesh(const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
             const base::Progress& progress) {
    if (options.cell > 0)
        return evenMesh(surface, options, options.cell, report, progress);
    const double cell = usualCell(surface.tree());
    if (!(options.adaptive > 0))
        if (const auto sizes = cubeSizesOf(surface, process::typicalSpacing(surface.tree()), cell,
                                           options.solid ? thinWalls(surface) : std::vector<float>()))
            return gradedMesh(surface, options, *sizes, report, progress);
    return evenMesh(surface, options, cell, report, progress);
}

} // namespace mesh
