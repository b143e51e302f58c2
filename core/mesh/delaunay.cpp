#include "core/mesh/delaunay.h"

#include "core/base/error.h"
#include "core/mesh/delaunay_finish.h"
#include "core/mesh/delaunay_start.h"
#include "core/mesh/mesh_attributes.h"
#include "core/mesh/mesh_repair.h"
#include "core/mesh/orient_mesh.h"
#include "core/process/part_progress.h"
#include "core/process/spacing_field.h"
#include "core/process/spacing_sample.h"

namespace mesh {

using base::Vec3d;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

/// A demand in lengths, defaults filled in.
FacetDemand demandOf(const surface::Surface& surface, const DelaunayOptions& options, const base::Progress& progress) {
    const double spacing = double(process::typicalSpacing(surface.tree()));
    const double unit = spacing > 0 ? spacing : double(surface.tree().maxSupport()) * surface::spacingOfUnit;
    FacetDemand out;
    out.leastAngle = options.angle * degree;
    double least = options.size > 0 ? options.size : unit;
    out.size = [least](const Vec3d&) { return least; };
    out.distance = options.distance > 0 ? options.distance : options.adaptive > 0 ? options.adaptive : 0.1 * unit;
    if (options.adaptive > 0) {
        // A facet of radius r on a surface of curvature k stays within r^2 k / 2; the field gives sqrt(tolerance / k).
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
    // What a bumpy surface's finest triangles need, and some; folds would be refined forever.
    out.floor = std::min(0.1 * std::sqrt(out.distance * unit), least / 8);
    return out;
}

} // namespace

Mesh restrictedDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                        const base::Progress& progress) {
    if (surface.tree().empty() || surface.definition().manifold == surface::Manifold::Curve)
        throw base::Error("only a surface can be meshed", "", "choose a model with points of a surface");
    const FacetDemand demand = demandOf(surface, options, process::part(progress, 0, 0.05));
    RestrictedDelaunay triangulation(surface, demand);
    std::vector<Vec3d> taken;
    report = {};
    if (options.snapToRims)
        for (const RimChain& rim : rimChains(surface, demand.size, process::part(progress, 0.05, 0.1))) {
            triangulation.addRim(rim);
            taken.insert(taken.end(), rim.positions.begin(), rim.positions.end());
            ++report.rims;
        }
    triangulation.add(spreadPoints(surface, demand.size, taken, process::part(progress, 0.1, 0.2)));
    constexpr std::size_t rounds = 4;
    constexpr double reach = 2.5;
    Mesh out;
    for (report.rounds = 1;; ++report.rounds) {
        triangulation.refine(process::part(progress, 0.2, 0.9));
        out = triangulation.mesh();
        const std::vector<Vec3d> bare = uncoveredFeet(surface, demand.size, out, reach);
        report.uncovered = bare.size();
        if (bare.empty() || report.rounds == rounds)
            break;
        triangulation.add(bare);
    }
    report.unrefined = triangulation.unrefined();
    progress.step(0.9, "Finishing");
    report.removed = makeManifold(out);
    dropUnused(out);
    settleVertices(surface, demand.leastAngle, out);
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    orient(out, layout.normals && layout.oriented);
    takeAttributes(out, surface);
    return out;
}

} // namespace mesh
