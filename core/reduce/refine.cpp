#include "core/reduce/refine.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/estimation/part_progress.h"
#include "core/reduce/assemble.h"
#include "core/reduce/by_cells.h"
#include "core/reduce/cell_parts.h"
#include "core/reduce/coverage.h"
#include "core/reduce/density.h"
#include "core/reduce/placement.h"
#include "core/reduce/refine_cells.h"
#include "core/reduce/report_sum.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <sstream>

namespace reduce {

namespace {

/// Places for a sample, along each direction.
constexpr float placesPerSpacing = 2.4f;
/// A surfel lays out places as far as this part of its support; nearer surfels take theirs.
constexpr float laidOver = 0.75f;
constexpr std::size_t asked = 17;
/// Of a support: o grows so much from the last place to the rim, which is up to a step of places, 0.12 h, farther out.
constexpr float lastStep = 0.07f;
constexpr float leastFacing = 0.17f;
constexpr double mostPlaces = 4e8;

/// Candidates around one surfel: a grid in its tangent plane, where no other surfel of its sheet is nearer.
struct Candidates {
    std::vector<base::Vec3f> position, normal;
    std::vector<float> reach;

    void layOut(const Places& sheets, const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int slot,
                float step, std::vector<tree::Neighbour>& near) {
        const base::Vec3f p = block.position(slot), n = block.normal(slot);
        if (n == base::Vec3f{})
            return;
        tree.nearest(p, asked, near);
        std::vector<base::Vec3f> others;
        for (const tree::Neighbour& other : near)
            if (other.distanceSq > 0 && sheets.facing(n, other.block->normal(other.slot), leastFacing))
                others.push_back(other.block->position(other.slot) - p);
        const float radius = laidOver * block.support(slot);
        const base::Vec3f u = perpendicular(n), v = cross(n, u);
        const int reachSteps = static_cast<int>(radius / step);
        for (int i = -reachSteps; i <= reachSteps; ++i)
            for (int j = -reachSteps; j <= reachSteps; ++j) {
                const base::Vec3f q = u * (step * static_cast<float>(i)) + v * (step * static_cast<float>(j));
                const float own = lengthSq(q);
                const bool taken =
                    own > radius * radius || // in space: tangent planes over a bend meet where neither is nearer
                    std::any_of(others.begin(), others.end(), [&](const auto& o) { return distanceSq(q, o) < own; });
                if (taken)
                    continue;
                position.push_back(p + q);
                normal.push_back(n);
                reach.push_back(std::max(radius, step));
            }
    }
};

/// Feet all over the surface, about placesPerSpacing^2 for each sample that is to be.
Places placesAllOver(const surface::Surface& surface, float step, const base::Progress& progress) {
    Places out;
    out.oriented = surface.tree().layout()->normals && surface.tree().layout()->oriented;
    constexpr std::uint32_t blocksAtOnce = 32;
    for (std::uint32_t first = 0; first < surface.tree().blockCount(); first += blocksAtOnce) {
        const std::uint32_t n = std::min(blocksAtOnce, surface.tree().blockCount() - first);
        progress.step(double(first) / double(surface.tree().blockCount()), "Laying out places");
        std::vector<Candidates> parts(n);
        base::parallelFor(n, 1, [&](std::size_t k) {
            std::vector<tree::Neighbour> near;
            const surfel::BlockPtr block = surface.tree().block(first + static_cast<std::uint32_t>(k));
            for (int slot = 0; slot < block->size(); ++slot)
                parts[k].layOut(out, surface.tree(), *block, slot, step, near);
        });
        for (const Candidates& part : parts)
            appendFeet(surface, part.position, part.normal, part.reach, out);
    }
    return out;
}

/// What the surface can be worth in places of that step, by the supports.
void check(const surface::Surface& model, float spacing) {
    if (model.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(model.definition().manifold) + " cannot be refined, only surfaces", "refine",
                          "open a model whose points sample a surface");
    if (!(spacing > 0) || !std::isfinite(spacing))
        throw base::Error("spacing must be a length greater than 0", "refine");
    const double step = double(spacing / placesPerSpacing);
    double area = 0;
    model.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            area += double(block.support(slot)) * double(block.support(slot));
    });
    area *= std::numbers::pi / double(model.definition().support > 0 ? 38 : model.definition().neighbours);
    if (area / (step * step) > mostPlaces)
        throw base::Error("that spacing would make about " +
                              std::to_string(std::llround(area / double(spacing * spacing) / 1e6)) + " million surfels",
                          "refine", "choose a larger one");
}

/// Samples with that spacing where the places are.
struct Resampled {
    surface::Surface surface;
    Places places;
};
std::optional<Resampled> resampled(const surface::Surface& model, Places places, float spacing,
                                   const base::Progress& progress) {
    const surface::SurfaceDefinition usual;
    NumberedTree tree(places.position, places.normal, {});
    measureAreas(places, tree);
    const std::vector<float> shares = sharesBySpacing(places, spacing);
    double sum = 0;
    for (const float share : shares)
        sum += double(share);
    const auto count = static_cast<std::size_t>(std::llround(sum));
    if (count < 4)
        return std::nullopt;
    Sites sites = place(model, places, std::move(tree), shares, std::min(count, places.size()), progress);
    for (float& s : sites.spacing)
        s = spacing;
    cover(places, static_cast<float>(usual.neighbours), sites);
    return Resampled{assemble(model, sites, usual.neighbours), std::move(places)};
}

/// Each cell by itself, as far as the others leave it. Cells that the spacing leaves nothing of stay as they are.
Refined refineCells(const surface::Surface& model, float spacing, const base::Progress& progress) {
    const cells::CellSurface cells = *cells::CellSurface::of(model);
    const surface::SurfaceDefinition usual;
    std::vector<surfel::SurfelList> lists;
    Places all;
    ReportSum sum;
    const std::vector<Cell> parts = cellsOf(model);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const auto at = [&](double share) { return 0.9 * (double(k) + share) / double(parts.size()); };
        const surface::Surface own = surfaceOf(model, parts[k]);
        Places places = placesAllOver(own, spacing / placesPerSpacing, process::part(progress, at(0), at(0.3)));
        keepOnFace(cells, parts[k].label, places);
        std::optional<Resampled> fine;
        if (places.size() > 0)
            fine = resampled(own, std::move(places), spacing, process::part(progress, at(0.3), at(0.9)));
        if (!fine) {
            sum.keep(parts[k].size(), 0, 0);
            lists.push_back(parts[k].surfels);
            continue;
        }
        sum.add(verifyPlaces(fine->places, fine->surface, process::part(progress, at(0.9), at(1))),
                fine->places.size());
        all.position.insert(all.position.end(), fine->places.position.begin(), fine->places.position.end());
        lists.push_back(fine->surface.tree().surfels());
    }
    surfel::SurfelList fine = joined(std::move(lists));
    labelBySeams(cells, spacing, fine);
    const surface::Surface whole{tree::SurfelTree::build(fine),
                                 reducedDefinition(model.definition(), usual.neighbours)};
    return {bounded(model, whole, all, lastStep, process::part(progress, 0.9, 1)), sum.report()};
}

} // namespace

Refined refine(const surface::Surface& model, float spacing, const base::Progress& progress) {
    check(model, spacing);
    const base::CancelScope scope(progress.cancel);
    if (hasCells(model))
        return refineCells(model, spacing, progress);
    std::optional<Resampled> fine =
        resampled(model, placesAllOver(model, spacing / placesPerSpacing, process::part(progress, 0, 0.3)), spacing,
                  process::part(progress, 0.3, 0.8));
    if (!fine)
        throw base::Error("that spacing leaves no surface", "refine", "choose a smaller one");
    Refined out;
    out.surface = bounded(model, fine->surface, fine->places, lastStep);
    out.report = verifyPlaces(fine->places, out.surface, process::part(progress, 0.8, 1));
    return out;
}

std::string refinedSummaryOf(const Report& report, const std::string& what) {
    std::ostringstream out;
    out.precision(3);
    out << report.count << " surfels, " << report.rms << " from " << what << " (rms), " << report.max << " (most)";
    if (report.holes > 0)
        out << "; " << report.holes << " of its places miss them: a hole";
    return out.str();
}

} // namespace reduce
