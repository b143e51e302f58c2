#include "core/reduce/assemble.h"

#include "core/base/parallel.h"
#include "core/process/estimation/known_rims.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"
#include "core/surface/rims.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace reduce {

namespace {

constexpr std::size_t grain = 64;
/// Surfels count within so many spacings of a site, with a weight that falls to 0 there: about the area that it stands
/// for, so that colours finer than the samples are averaged and not picked.
constexpr float carriedOver = 1;
constexpr float leastFacing = 0.17f;
/// Limits are at most this, in units of h: o hardly grows beyond it where there is any surface.
constexpr float loosest = 0.5f;
constexpr float slack = 1.02f;
/// Where rims are fitted: from .22 to here a straight one moves by .07 h (surface/README 5.1).
constexpr float largestFitted = 0.26f, farthestOff = 0.3f;
/// In supports, so far from a rim the samples tell of it: the nearest to a rim may be 1.3 spacings off, and where one
/// knew nothing, the rim was broken.
constexpr float reachOfEnds = 0.8f;

/// What a site carries: of the model's surfels around it, of the nearest one where there are none.
void carry(const surface::Surface& model, const Sites& sites, std::size_t i, surfel::Surfel& out,
           std::span<std::uint32_t> words) {
    const surfel::AttributeLayout& layout = *model.tree().layout();
    surface::AttributeSum sum(layout);
    const base::Vec3f x = sites.position[i];
    const float reach = carriedOver * sites.spacing[i];
    model.tree().forBlocksInBall(x, reach, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const float d = distanceSq(block.position(slot), x);
            if (!(d < reach * reach))
                continue;
            const float cosine = dot(block.normal(slot), sites.normal[i]);
            if (layout.normals && (layout.oriented ? cosine : std::abs(cosine)) <= leastFacing)
                continue;
            if (const float w = surface::wendlandC2(std::sqrt(d) / reach); w > 0)
                sum.add(block, slot, w);
        }
    });
    if (!sum.any()) {
        std::vector<tree::Neighbour> near;
        model.tree().nearest(x, 1, near);
        sum.add(*near.front().block, near.front().slot, 1);
    }
    out.colour = sum.colour();
    out.mask = sum.mask();
    sum.further(words);
}

} // namespace

surface::SurfaceDefinition reducedDefinition(const surface::SurfaceDefinition& model, int neighbours) {
    surface::SurfaceDefinition out = model;
    out.frame = surface::Frame::Normals;
    out.weight = surface::Weight::Wendland;
    out.support = 0;
    out.neighbours = neighbours;
    out.shrinkFree = true;
    out.interpolating = false;
    out.boundaryLimit = std::numeric_limits<float>::infinity();
    out.knownRims = false; // supports grew
    return out;
}

surface::Surface assemble(const surface::Surface& model, const Sites& sites, int neighbours) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*model.tree().layout());
    layout->normals = true;
    layout->oriented = layout->oriented && model.tree().layout()->normals;
    surfel::SurfelList list;
    list.layout = layout;
    list.items.resize(sites.size());
    if (!sites.shape.empty())
        surfel::addShape(*layout);
    const std::size_t words = layout->words(), carried = model.tree().layout()->words();
    const std::size_t first = sites.shape.empty() ? 0 : surfel::shapeWord(*layout);
    list.extra.resize(sites.size() * words);
    base::parallelFor(sites.size(), grain, [&](std::size_t i) {
        surfel::Surfel& s = list.items[i];
        s.position = sites.position[i];
        s.normal = sites.normal[i];
        s.support = sites.support[i];
        const auto own = std::span(list.extra).subspan(i * words, words);
        carry(model, sites, i, s, own.first(carried));
        if (!sites.shape.empty())
            surfel::putShape(own, first, sites.shape[i]);
    });
    if (sites.shape.empty())
        list = surfel::withoutShape(list);
    return {tree::SurfelTree::build(list), reducedDefinition(model.definition(), neighbours)};
}

/// The largest o / h at the places, of those with one of these states.
static float mostOff(const surface::Surface& surface, const Places& places, bool lost, const base::Progress& progress) {
    constexpr std::size_t slab = 1 << 14;
    std::vector<surface::Evaluationf> at(std::min(slab, places.size()));
    float most = 0;
    for (std::size_t begin = 0; begin < places.size(); begin += slab) {
        progress.step(double(begin) / double(places.size()), "Finding the boundary");
        const std::size_t n = std::min(slab, places.size() - begin);
        surface.evaluate(std::span(places.position).subspan(begin, n), surface::Need::Value, std::span(at).first(n));
        for (std::size_t k = 0; k < n; ++k)
            if (lost ? at[k].status == surface::Status::BeyondBoundary : at[k].ok())
                most = std::max(most, at[k].offCentre / at[k].unit);
    }
    return most;
}

static surface::Surface withLimit(const surface::Surface& surface, float limit) {
    surface::SurfaceDefinition definition = surface.definition();
    definition.boundaryLimit = limit;
    return {surface.tree(), definition};
}

surface::Surface bounded(const surface::Surface& model, const surface::Surface& surface, const Places& places,
                         float beyond, const base::Progress& progress) {
    if (!std::isfinite(model.definition().boundaryLimit))
        return surface;
    return withLimit(surface, std::min(slack * mostOff(surface, places, false, progress) + beyond, loosest));
}

surface::Surface endingAtRims(const surface::Surface& model, const surface::Surface& surface, const Places& places,
                              const Rims& rims, float limit, const base::Progress& progress) {
    surface::Surface out = withLimit(surface, limit);
    if (process::mayKnowRims(model)) {
        std::vector<base::Vec3d> ends;
        for (const base::Vec3f& x : rims.position)
            ends.push_back(base::cast<double>(x));
        out = process::endingAt(out, ends, reachOfEnds);
    }
    // Rims that are ragged everywhere, as of raw scans, cannot be followed: there nothing is to be lost.
    return withLimit(out, std::clamp(slack * mostOff(out, places, true, progress), limit,
                                     limit > largestFitted ? loosest : farthestOff));
}

} // namespace reduce
