#include "core/mesh/marching/marching_cubes.h"

#include "core/mesh/finish/close_folds.h"
#include "core/mesh/finish/drop_crumbs.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/finish/trim_folds.h"
#include "core/mesh/finish/untangle.h"
#include "core/mesh/marching/cut_mesh.h"
#include "core/mesh/marching/hold_tolerance.h"
#include "core/mesh/marching/relax_mesh.h"
#include "core/mesh/seams/keep_creases.h"
#include "core/mesh/surface_parts.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <numbers>

namespace mesh {

namespace {

/// Are cubes of several sizes because the surfels are, and not for a tolerance?
bool graded(const MarchingOptions& options, const MarchingReport& report) {
    return !(options.adaptive > 0) && report.largestCell > report.cell;
}

/// Of each vertex about the side of its cubes, which is what its longest edge is the diagonal of a face of.
std::vector<float> cellsAbout(const Mesh& mesh) {
    std::vector<float> out(mesh.positions.size());
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            const auto side =
                static_cast<float>(base::distance(mesh.positions[a], mesh.positions[b]) / std::numbers::sqrt2);
            out[a] = std::max(out[a], side);
            out[b] = std::max(out[b], side);
        }
    return out;
}

RelaxOptions shapingOf(const Mesh& mesh, const MarchingOptions& options, const MarchingReport& report) {
    RelaxOptions out{options.relax ? 2 : 0, 0.7, report.cell, {}, {}};
    if (graded(options, report))
        out.cells = cellsAbout(mesh);
    return out;
}

/// Of a solid no triangle is left out: what cuts another one then goes back to the edges of its cube.
void shape(Mesh& mesh, const surface::Surface& surface, const MarchingOptions& options, const MarchingReport& report,
           const base::Progress& progress) {
    const RelaxOptions shaping = shapingOf(mesh, options, report);
    const bool sided = solidTraits(surface, options).sided,
               joined = options.adaptive > 0 && report.largestCell > report.cell;
    if (!sided && !joined)
        return relax(mesh, surface, shaping, progress);
    const VertexPlaces before{mesh.positions, mesh.normals};
    relax(mesh, surface, shaping, process::part(progress, 0, 0.8));
    if (joined)
        holdTolerance(mesh, surface, before, options.adaptive);
    if (sided)
        untangle(mesh, before, graded(options, report) ? report.largestCell : report.cell,
                 process::part(progress, 0.8, 1));
}

/// Loops at folds are closed, and triangles shaped that are near those.
std::vector<std::uint32_t> close(Mesh& mesh, const surface::Surface& surface, const FoldClosing& closing,
                                 RelaxOptions shaping, const base::Progress& progress) {
    shaping.about = closeFolds(mesh, surface, closing);
    if (!shaping.cells.empty())
        shaping.cells = cellsAbout(mesh);
    if (!shaping.about.empty())
        relax(mesh, surface, shaping, progress);
    return shaping.about;
}

/// Short loops are closed where the surface is there, what cuts other triangles is left out, and what is still open
/// closed on request.
void finishFolds(Mesh& mesh, const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
                 const base::Progress& progress) {
    const RelaxOptions shaping = shapingOf(mesh, options, report);
    if (solidTraits(surface, options).closed)
        return;
    // what cuts is looked for about the largest; a middle may be as far off as its own loop is wide
    const double widest = graded(options, report) ? report.largestCell : report.cell;
    FoldClosing closing{graded(options, report) ? 0 : report.cell, false, options.finishing.longestFold};
    const auto middles = close(mesh, surface, closing, shaping, process::part(progress, 0, 0.4));
    report.foldsClosed = middles.size() - reopenCut(mesh, middles, widest);
    report.trimmed = trimFolds(mesh, widest);
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

/// What hangs together, or is of about one spacing.
Mesh marchPart(const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
               const base::Progress& progress) {
    Mesh out = cutMesh(surface, options, report, process::part(progress, 0, 0.7));
    if (out.triangles.empty())
        throw base::Error("no surface was found to mesh", "",
                          "check normals, supports, the boundary limit and, where one was given, the cell size");
    progress.step(0.7, "orienting triangles");
    const Orientation orientation = orient(out, SurfaceTraits(surface).oriented);
    report.parityConflicts = orientation.conflicts;
    report.pieces = orientation.pieceSizes.size();
    report.smallPieces = static_cast<std::size_t>(
        std::count_if(orientation.pieceSizes.begin(), orientation.pieceSizes.end(),
                      [&](std::uint32_t size) { return size < options.finishing.smallPiece; }));
    if (options.finishing.dropSmall)
        dropSmallPieces(out, orientation, options.finishing.smallPiece);
    else if (const std::size_t crumbs = dropCrumbs(out, orientation, surface); crumbs > 0) {
        report.pieces -= crumbs;
        dropUnused(out);
    }
    shape(out, surface, options, report, process::part(progress, 0.75, 0.93));
    finishFolds(out, surface, options, report, process::part(progress, 0.93, 0.95));
    if (!options.creases || !keepCreases(out, surface, process::part(progress, 0.95, 1)))
        takeAttributes(out, surface);
    progress.step(1, "shaping triangles");
    return out;
}

/// Each in cubes of its own.
Mesh marchParts(std::span<const surface::Surface> parts, const MarchingOptions& options, MarchingReport& report,
                const base::Progress& progress) {
    Mesh out;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = [&](std::size_t k) { return static_cast<double>(k) / static_cast<double>(parts.size()); };
        MarchingReport own;
        append(out, marchPart(parts[i], options, own, process::part(progress, share(i), share(i + 1))));
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
    return marchPart(surface, options, report, progress);
}

} // namespace mesh
