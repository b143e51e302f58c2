#include "core/reduce/refine.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/estimation/part_progress.h"
#include "core/reduce/assemble.h"
#include "core/reduce/coverage.h"
#include "core/reduce/density.h"
#include "core/reduce/placement.h"

#include <algorithm>
#include <numbers>
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
                    own > radius * radius || std::any_of(others.begin(), others.end(), [&](const auto& o) {
                        const base::Vec3f flat = o - n * dot(n, o);
                        return distanceSq(q, flat) < own;
                    });
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
    if (model.definition().manifold == surface::Manifold::Curve)
        throw base::Error("curves cannot be refined, only surfaces", "refine",
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

} // namespace

Refined refine(const surface::Surface& model, float spacing, const base::Progress& progress) {
    check(model, spacing);
    const base::CancelScope scope(progress.cancel);
    const surface::SurfaceDefinition usual;
    Dense dense;
    dense.surface = model;
    dense.places = placesAllOver(model, spacing / placesPerSpacing, process::part(progress, 0, 0.3));
    Places& places = dense.places;
    NumberedTree tree(places.position, places.normal, {});
    measureAreas(places, tree);
    const std::vector<float> shares = sharesBySpacing(places, spacing);
    double sum = 0;
    for (const float share : shares)
        sum += double(share);
    const auto count = static_cast<std::size_t>(std::llround(sum));
    if (count < 4)
        throw base::Error("that spacing leaves no surface", "refine", "choose a smaller one");
    Sites sites = place(model, places, std::move(tree), shares, std::min(count, places.size()),
                        process::part(progress, 0.3, 0.8));
    for (float& s : sites.spacing)
        s = spacing;
    cover(places, static_cast<float>(usual.neighbours), sites);
    Refined out;
    out.surface = bounded(model, assemble(model, sites, usual.neighbours), places, lastStep);
    out.report = verifyPlaces(places, out.surface, process::part(progress, 0.8, 1));
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
