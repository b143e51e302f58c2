#include "core/mesh/marching/marching_cubes.h"

#include "core/base/parallel.h"
#include "core/mesh/cell_size.h"
#include "core/mesh/finish/close_folds.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/finish/trim_folds.h"
#include "core/mesh/finish/untangle.h"
#include "core/mesh/marching/cube_filler.h"
#include "core/mesh/marching/cube_tree.h"
#include "core/mesh/marching/hold_tolerance.h"
#include "core/mesh/marching/relax_mesh.h"
#include "core/mesh/seams/keep_creases.h"
#include "core/mesh/surface_parts.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <optional>

namespace mesh {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t bricksPerTask = 64;
constexpr double margin = 8; ///< in cells, around everything

SurfaceTraits traitsOf(const surface::Surface& surface, const MarchingOptions& options) {
    SurfaceTraits out(surface);
    out.closed = out.closed && options.solid;
    return out;
}

Lattice latticeFor(const surface::Surface& surface, const MarchingOptions& options) {
    Lattice out;
    out.cell = options.cell > 0 ? options.cell : usualCell(surface.tree());
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
    if (std::max({size.x, size.y, size.z}) + 4 * margin > Lattice::extent)
        throw base::Error("the cells are too small for a model of this size", "", "choose larger cells");
    const Vec3d around = Vec3d{margin, margin, margin} + options.shift;
    out.origin = transposed(out.turned) * (turned.lo - around * out.cell);
    return out;
}

/// Traces loose ends; edges beside those that end in nothing are walked again with care, twice at most.
LooseEnds settleEnds(SurfaceGrid& grid, std::vector<TracedEnd>& boundary, MarchingReport& report,
                     const base::Progress& progress) {
    constexpr int rounds = 2;
    for (int round = 0;; ++round) {
        std::vector<LooseEnd> ends = looseEnds(grid);
        const std::vector<TracedEnd> traced = trace(grid, ends, process::part(progress, 0.8, 0.85));
        std::vector<SurfaceGrid::EdgeName> doubtful;
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (traced[i].end != TraceEnd::Limit)
                for (int side = 0; side < 4; ++side)
                    doubtful.push_back(GridFace::edge(ends[i].face.place, ends[i].axis, side));
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

void addVertices(const SurfaceGrid& grid, std::span<const TracedEnd> boundary, Mesh& out) {
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

/// Triangles as cubes make them, each loop facing as its normals do.
Mesh cutMesh(const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
             const base::Progress& progress) {
    const Lattice lattice = latticeFor(surface, options);
    report.cell = lattice.cell;
    SurfaceGrid grid(surface, traitsOf(surface, options), lattice);
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

RelaxOptions shapingOf(const MarchingOptions& options, const MarchingReport& report) {
    return {options.relax ? 2 : 0, 0.7, report.cell, {}};
}

/// Of a solid no triangle is left out: what cuts another one then goes back to the edges of its cube.
void shape(Mesh& mesh, const surface::Surface& surface, const MarchingOptions& options, const MarchingReport& report,
           const base::Progress& progress) {
    const RelaxOptions shaping = shapingOf(options, report);
    const bool closed = traitsOf(surface, options).closed, joined = report.largestCell > report.cell;
    if (!closed && !joined)
        return relax(mesh, surface, shaping, progress);
    const VertexPlaces before{mesh.positions, mesh.normals};
    relax(mesh, surface, shaping, process::part(progress, 0, 0.8));
    if (joined)
        holdTolerance(mesh, surface, before, options.adaptive);
    if (closed)
        untangle(mesh, before, shaping.cell, process::part(progress, 0.8, 1));
}

/// Loops at folds are closed, and triangles shaped that are near those.
std::vector<std::uint32_t> close(Mesh& mesh, const surface::Surface& surface, const FoldClosing& closing,
                                 RelaxOptions shaping, const base::Progress& progress) {
    shaping.about = closeFolds(mesh, surface, closing);
    if (!shaping.about.empty())
        relax(mesh, surface, shaping, progress);
    return shaping.about;
}

/// Short loops are closed where the surface is there, what cuts other triangles is left out, and what is still open
/// closed on request.
void finishFolds(Mesh& mesh, const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
                 const base::Progress& progress) {
    const RelaxOptions shaping = shapingOf(options, report);
    if (traitsOf(surface, options).closed)
        return;
    FoldClosing closing{report.cell, false, options.finishing.longestFold};
    const auto middles = close(mesh, surface, closing, shaping, process::part(progress, 0, 0.4));
    report.foldsClosed = middles.size() - reopenCut(mesh, middles, report.cell);
    report.trimmed = trimFolds(mesh, report.cell);
    closing.everyLoop = true;
    if (options.finishing.closeFolds)
        report.foldsClosed += close(mesh, surface, closing, shaping, process::part(progress, 0.4, 1)).size();
}

void add(MarchingReport& report, const MarchingReport& more) {
    report.cell = report.cell > 0 ? std::min(report.cell, more.cell) : more.cell;
    report.largestCell = std::max(report.largestCell, more.largestCell);
    for (const auto count : {&MarchingReport::cubes, &MarchingReport::limitEnds, &MarchingReport::foldEnds,
                             &MarchingReport::foldsClosed, &MarchingReport::trimmed, &MarchingReport::pieces,
                             &MarchingReport::smallPieces, &MarchingReport::parityConflicts})
        report.*count += more.*count;
}

/// Each in cubes of its own.
Mesh marchParts(std::span<const surface::Surface> parts, MarchingOptions options, MarchingReport& report,
                const base::Progress& progress) {
    Mesh out;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(parts.size()); };
        options.cell = usualCell(parts[i].tree());
        MarchingReport own;
        append(out, marchingCubes(parts[i], options, own, process::part(progress, share(i), share(i + 1))));
        add(report, own);
    }
    return out;
}

} // namespace

Mesh marchingCubes(const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
                   const base::Progress& progress) {
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) + " has no surface to mesh", "",
                          "choose the manifold 'surface'");
    if (surface.tree().empty())
        throw base::Error("the model has no surfels");
    report = {};
    if (!(options.cell > 0))
        if (const std::vector<surface::Surface> parts = partsOf(surface, process::part(progress, 0, 0.02));
            parts.size() > 1)
            return marchParts(parts, options, report, process::part(progress, 0.02, 1));
    Mesh out = cutMesh(surface, options, report, process::part(progress, 0, 0.7));
    if (out.triangles.empty())
        throw base::Error("no surface was found to mesh", "", "check normals, supports and the boundary limit");
    progress.step(0.7, "orienting triangles");
    const Orientation orientation = orient(out, SurfaceTraits(surface).oriented);
    report.parityConflicts = orientation.conflicts;
    report.pieces = orientation.pieceSizes.size();
    report.smallPieces = static_cast<std::size_t>(
        std::count_if(orientation.pieceSizes.begin(), orientation.pieceSizes.end(),
                      [&](std::uint32_t size) { return size < options.finishing.smallPiece; }));
    if (options.finishing.dropSmall)
        dropSmallPieces(out, orientation, options.finishing.smallPiece);
    shape(out, surface, options, report, process::part(progress, 0.75, 0.93));
    finishFolds(out, surface, options, report, process::part(progress, 0.93, 0.95));
    if (!options.creases || !keepCreases(out, surface, process::part(progress, 0.95, 1)))
        takeAttributes(out, surface);
    progress.step(1, "shaping triangles");
    return out;
}

} // namespace mesh
