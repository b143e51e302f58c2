#include "core/mesh/delaunay/delaunay.h"

#include "core/base/error.h"
#include "core/mesh/cell_size.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/check/shape.h"
#include "core/mesh/delaunay/delaunay_finish.h"
#include "core/mesh/delaunay/delaunay_refine.h"
#include "core/mesh/delaunay/held_faces.h"
#include "core/mesh/finish/close_folds.h"
#include "core/mesh/finish/drop_crumbs.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/make_manifold.h"
#include "core/mesh/finish/mesh_attributes.h"
#include "core/mesh/finish/trim_folds.h"
#include "core/mesh/finish/untangle.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/mesh/marching/thin_walls.h"
#include "core/mesh/seams/keep_creases.h"
#include "core/mesh/surface_parts.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/spacing_field.h"

#include <algorithm>
#include <optional>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// Throws where the smallest triangles allowed would be more than can be numbered.
void checkCount(const surface::Surface& surface, const FaceDemand& demand, double least, double unit) {
    constexpr double most = 3e8;
    const double radius = std::min(least, std::sqrt(demand.distance * unit));
    if (double(surface.tree().size()) * unit * unit > most * radius * radius)
        throw base::Error("the triangles are too small for a model of this size", "",
                          "choose a larger size or distance");
}

/// A demand in lengths, defaults filled in.
FaceDemand demandOf(const surface::Surface& surface, const DelaunayOptions& options, double unit,
                    const base::Progress& progress) {
    FaceDemand out;
    constexpr double spare = 1e-3; // degrees that settling may take
    out.leastAngle = (options.angle + spare) * degree;
    double least = options.size > 0 ? options.size : unit;
    out.size = [least](const Vec3d&) { return least; };
    out.distance = options.distance > 0 ? options.distance : options.adaptive > 0 ? options.adaptive : 0.1 * unit;
    if (options.adaptive > 0) {
        // A face of radius r on a surface of curvature k stays within r^2 k / 2; the field gives sqrt(tolerance / k).
        constexpr float fine = 0.25f, coarse = 8;
        process::CurvatureSpacing by;
        by.tolerance = static_cast<float>(2 * options.adaptive);
        by.finest = fine * static_cast<float>(unit);
        by.coarsest = options.size > 0 ? static_cast<float>(options.size) : coarse * static_cast<float>(unit);
        const auto field =
            std::make_shared<process::SpacingField>(process::SpacingField::byCurvature(surface, by, progress));
        out.size = [field](const Vec3d& x) { return double(field->at(base::cast<float>(x))); };
        least = double(by.finest);
    }
    checkCount(surface, out, least, unit);
    // What a bumpy surface's finest triangles need, and some; folds would be refined forever.
    out.floor = std::min(0.1 * std::sqrt(out.distance * unit), least / 8);
    out.foldFloor = std::max(out.floor, 0.25 * std::min(least, unit));
    return out;
}

/// Cubes as large as the median spacing, or up to a third of it where some of the surfels are that much denser.
double guideCell(const surface::Surface& surface, double unit) {
    std::vector<process::SpacingSample> samples = process::sampleSpacing(surface.tree());
    std::sort(samples.begin(), samples.end(),
              [](const process::SpacingSample& a, const process::SpacingSample& b) { return a.spacing < b.spacing; });
    return samples.empty() ? unit : std::clamp(double(samples[samples.size() / 20].spacing), unit / 3, unit);
}

/// The same for closed surfaces, but finer only where it must be: over gaps, small cubes make handles.
double closedGuideCell(double finer, double unit) {
    constexpr double much = 0.5;
    return finer < much * unit ? finer : unit;
}

/// Leaves out faces of cubes that are nowhere near the surface, as at folds.
Mesh trimmed(const surface::Surface& surface, const Mesh& mesh, const base::Progress& progress) {
    constexpr double facing = 0.2, tall = 0.5;
    const bool oriented = SurfaceTraits(surface).oriented;
    SurfaceTriangulation faces(surface, mesh);
    std::vector<bool> leftOut(mesh.triangles.size());
    for (std::uint32_t f = 0; f < leftOut.size(); ++f) {
        if (f % 4096 == 0)
            progress.step(double(f) / double(leftOut.size()), "Looking for folds");
        const Triangle& t = mesh.triangles[f];
        const auto [a, b, c] = faces.cornersOf(t);
        const double cosine = oriented ? faces.facing(t) : std::abs(faces.facing(t));
        const double reach = tall * std::max({distance(a, b), distance(b, c), distance(c, a)});
        leftOut[f] =
            cosine < facing || !faces.root((a + b + c) / 3, faces.faceNormal(t), reach, {faces.surfaceNormal(t)});
    }
    Mesh out = faces.mesh(leftOut);
    makeManifold(out);
    dropUnused(out);
    return out;
}

/// Of one size; of several where walls are so thin that cubes of one size do not see them.
Mesh cubesOf(const surface::Surface& surface, double cell, const base::Progress& progress) {
    MarchingOptions options;
    options.cell = thinWalls(surface).empty() ? cell : 0;
    options.creases = false;
    MarchingReport report;
    return marchingCubes(surface, options, report, progress);
}

/// Takes away what the demand, the surface or a request says, and fills in what the mesh has besides its triangles.
void finish(const surface::Surface& surface, const DelaunayOptions& options, const FaceDemand& demand, double unit,
            Mesh& mesh, DelaunayReport& report) {
    settleVertices(surface, options.angle * degree, mesh);
    report.unrefined += leaveOutFar(surface, demand.distance, mesh);
    report.removed = makeManifold(mesh);
    tellBoundaryKinds(surface, mesh);
    report.trimmed = trimFolds(mesh, 0.5 * shapeOf(mesh).longestEdge);
    if (report.trimmed > 0)
        tellBoundaryKinds(surface, mesh);
    const Orientation orientation = orient(mesh, SurfaceTraits(surface).oriented);
    if (options.finishing.dropSmall)
        dropSmallPieces(mesh, orientation, options.finishing.smallPiece);
    else
        report.unrefined += dropCrumbs(mesh, orientation, surface);
    if (options.finishing.closeFolds)
        report.foldsClosed = closeFolds(mesh, surface, {unit, true, options.finishing.longestFold}).size();
    dropUnused(mesh);
    takeAttributes(mesh, surface);
}

/// A closed mesh stays as it is: vertices come to rest on the surface where that cuts nothing.
void finishClosed(const surface::Surface& surface, const DelaunayOptions& options, Mesh& mesh,
                  const base::Progress& progress) {
    const VertexPlaces before{mesh.positions, mesh.normals};
    settleVertices(surface, options.angle * degree, mesh);
    untangle(mesh, before, 0.5 * shapeOf(mesh).longestEdge, progress);
    const Orientation orientation = orient(mesh, true);
    if (options.finishing.dropSmall)
        dropSmallPieces(mesh, orientation, options.finishing.smallPiece);
    dropUnused(mesh);
    takeAttributes(mesh, surface);
}

/// Without a boundary, whatever the points: of cubes that know inside and outside, by edits that keep it so.
Mesh closedDelaunay(const surface::Surface& surface, const DelaunayOptions& options, const FaceDemand& demand,
                    double cell, const Mesh& cubes, DelaunayReport& report, const base::Progress& progress) {
    constexpr double edges = 1.5; // of the guide, in a cube of the guard
    const Asking asking = SurfaceTraits(surface).continuous ? Asking::AsItIs : Asking::OwnSheet;
    SurfaceTriangulation faces(surface, cubes, asking);
    KeptClosed closed(faces, heldFaces(faces, process::part(progress, 0.3, 0.35)), edges * cell);
    coarsen(faces, demand.size, demand.distance, process::part(progress, 0.35, 0.4), &closed);
    DelaunayRefinement refinement(faces, demand, &closed);
    refinement.run(process::part(progress, 0.4, 0.9));
    const std::vector<bool> failing = refinement.failing();
    report.missed = static_cast<std::size_t>(std::count(failing.begin(), failing.end(), true));
    shapeHeld(faces, closed, process::part(progress, 0.9, 0.92));
    Mesh out = faces.mesh(bubbles(faces, closed));
    finishClosed(surface, options, out, process::part(progress, 0.92, 1));
    return out;
}

/// As the surface lies, with everything left out that is none. Nothing where that is not `all` and all was asked for.
std::optional<Mesh> marchedDelaunay(const surface::Surface& surface, const DelaunayOptions& options,
                                    const FaceDemand& demand, double unit, const Mesh& cubes, bool all,
                                    DelaunayReport& report, const base::Progress& progress) {
    const Mesh guide = trimmed(surface, cubes, process::part(progress, 0.3, 0.35));
    if (all && guide.triangles.size() < cubes.triangles.size())
        return {};
    SurfaceTriangulation faces(surface, guide);
    coarsen(faces, demand.size, demand.distance, process::part(progress, 0.35, 0.4));
    DelaunayRefinement refinement(faces, demand);
    refinement.run(process::part(progress, 0.4, 0.9));
    const std::vector<bool> failing = refinement.failing();
    report.unrefined = static_cast<std::size_t>(std::count(failing.begin(), failing.end(), true));
    if (all && report.unrefined > 0)
        return {};
    progress.step(0.9, "Finishing");
    Mesh out = faces.mesh(failing);
    finish(surface, options, demand, unit, out, report);
    const bool whole = report.unrefined + report.removed + report.trimmed + report.foldsClosed == 0;
    if (all && !(whole && selfIntersections(out, process::part(progress, 0.95, 1)).empty()))
        return {};
    return out;
}

/// Round where cells meet.
Mesh smoothDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                    const base::Progress& progress) {
    const double unit = usualCell(surface.tree());
    const FaceDemand demand = demandOf(surface, options, unit, process::part(progress, 0, 0.05));
    report = {};
    const bool closed = SurfaceTraits(surface).closed;
    const base::Progress first = closed ? process::part(progress, 0, 0.5) : progress;
    const double cell = guideCell(surface, unit), closedCell = closedGuideCell(cell, unit);
    Mesh cubes = cubesOf(surface, cell, process::part(first, 0.05, 0.3));
    if (std::optional<Mesh> mesh = marchedDelaunay(surface, options, demand, unit, cubes, closed, report, first))
        return std::move(*mesh);
    report = {};
    const base::Progress second = process::part(progress, 0.5, 1);
    if (closedCell != cell)
        cubes = cubesOf(surface, closedCell, process::part(second, 0, 0.3));
    return closedDelaunay(surface, options, demand, closedCell, cubes, report, second);
}

Mesh partDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                  const base::Progress& progress) {
    Mesh out = smoothDelaunay(surface, options, report, process::part(progress, 0, 0.9));
    if (options.creases)
        keepCreases(out, surface, process::part(progress, 0.9, 1));
    return out;
}

void add(DelaunayReport& report, const DelaunayReport& more) {
    for (const auto count : {&DelaunayReport::unrefined, &DelaunayReport::removed, &DelaunayReport::trimmed,
                             &DelaunayReport::foldsClosed, &DelaunayReport::missed})
        report.*count += more.*count;
}

} // namespace

Mesh restrictedDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                        const base::Progress& progress) {
    if (surface.tree().empty() || surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error("only a surface can be meshed", "", "choose a model with points of a surface");
    report = {};
    if (options.size > 0)
        return partDelaunay(surface, options, report, progress);
    const std::vector<surface::Surface> parts = partsOf(surface, process::part(progress, 0, 0.02));
    if (parts.size() < 2)
        return partDelaunay(surface, options, report, progress);
    Mesh out;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = [&](std::size_t k) {
            return 0.02 + 0.98 * static_cast<double>(k) / static_cast<double>(parts.size());
        };
        DelaunayReport own;
        append(out, partDelaunay(parts[i], options, own, process::part(progress, share(i), share(i + 1))));
        add(report, own);
    }
    return out;
}

} // namespace mesh
