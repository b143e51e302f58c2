#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/resampling/resample_blend.h"
#include "core/process/resampling/resample_fit.h"
#include "core/process/resampling/resample_land.h"
#include "core/process/resampling/resample_set.h"
#include "core/surface/rims.h"
#include "core/surfel/shape.h"

#include <cmath>

namespace process {

namespace {

constexpr int steps = 12;
constexpr float tolerance = 1e-5f; ///< of the support
constexpr std::size_t grain = 32;
/// By weight, of what is about a sample off centre: in the middle of a sheet it is none, and half is the rule
/// elsewhere.
constexpr float enoughOfRims = 0.25f;

/// What becomes of one sample that moved or is new.
struct Settled {
    surfel::Surfel surfel;
    std::vector<std::uint32_t> words;
};

/// The smallest rotation that takes the unit vector a to b, applied to v.
base::Vec3f rotated(const base::Vec3f& v, const base::Vec3f& a, const base::Vec3f& b) {
    const float c = dot(a, b);
    if (c < -0.999f)
        return v; // no smallest one
    const base::Vec3f h = a + b;
    return v - h * (dot(h, v) / (1 + c)) + b * (2 * dot(a, v));
}

/// A normal that leans further than this from the surface belongs to a fold; then the surface's own takes its place.
constexpr float leastUpright = 0.5f;
base::Vec3f upright(const base::Vec3f& n, const base::Vec3f& g) {
    return dot(n, g) < leastUpright ? g : n;
}

/// Landings of all samples that need one; those that find no surface go back to where they were, or go.
std::vector<std::uint32_t> landAll(SampleSet& set, std::vector<Landing>& landings) {
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        if (set.is(i, Moved) && !set.is(i, Gone))
            out.push_back(i);
    std::vector<base::Vec3f> places(out.size()), sides(out.size());
    for (std::size_t k = 0; k < out.size(); ++k)
        places[k] = set.position[out[k]], sides[k] = set.normal[out[k]];
    landings = landTogether(set.frozen, places, sides, steps, tolerance * set.options.support);
    for (std::size_t k = 0; k < out.size(); ++k) {
        const std::uint32_t i = out[k];
        const float far = set.target[i] * set.target[i];
        landings[k].ok = landings[k].ok && distanceSq(landings[k].place, places[k]) < far;
        if (!landings[k].ok)
            set.unmark(i, Moved), set.mark(i, set.is(i, New) ? Gone : 0);
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < out.size(); ++k)
        if (landings[k].ok)
            out[kept] = out[k], landings[kept] = landings[k], ++kept;
    out.resize(kept);
    landings.resize(kept);
    return out;
}

float supportAt(const SampleSet& set, std::uint32_t i, const base::Vec3f& place, const Blend& blend) {
    if (set.options.targetOf && !set.is(i, New))
        return surfel::ballOf(*set.block[set.source[i].block], set.source[i].slot,
                              surfel::shapeChannel(*set.version.tree().layout()));
    if (set.options.targetOf && blend.support > 0)
        return blend.support;
    return set.options.field ? supportOf(set.version.definition(), set.options.field->at(place)) : set.options.support;
}

Settled settled(const SampleSet& set, std::uint32_t i, const Landing& y, const Blender& blender, Blender::Near& near) {
    Blend blend;
    base::Vec3f g = y.gradient;
    if (dot(g, set.normal[i]) < 0 && set.facing.known())
        g = -g;
    blender.at(y.place, g, near, blend);
    Settled out;
    out.surfel.position = y.place + g * blend.height;
    out.surfel.support = supportAt(set, i, y.place, blend);
    out.surfel.colour = blend.colour;
    if (set.is(i, New)) {
        out.surfel.mask = blend.mask;
        out.surfel.normal = normalized(g + blend.tilt, g);
    } else {
        base::Vec3f was = set.oldGradient[i];
        if (dot(was, set.normal[i]) < 0)
            was = -was;
        out.surfel.mask = set.block[set.source[i].block]->mask(set.source[i].slot);
        out.surfel.normal = upright(normalized(rotated(set.normal[i], was, g), g), g);
    }
    if (!set.facing.known())
        out.surfel.normal = {};
    out.words = std::move(blend.words);
    // What weighs most there may be of rows behind the last, where a stroke has drawn that one apart.
    if (blend.ofRims > enoughOfRims && y.at.offCentre > set.pinned * y.at.unit)
        surfel::write(*set.version.tree().layout()->find(surface::rimName), out.words, 1);
    return out;
}

/// Edits of the version's blocks, and the new surfels in the order of their birth.
tree::Edit editOf(const SampleSet& set, const std::vector<std::uint32_t>& which, const std::vector<Settled>& settled) {
    std::vector<std::int64_t> at(set.size(), -1);
    for (std::size_t k = 0; k < which.size(); ++k)
        at[which[k]] = static_cast<std::int64_t>(k);
    tree::Edit edit;
    edit.inserted.layout = set.version.tree().layout();
    for (std::size_t i = 0; i < set.oldCount();) {
        base::CancelScope::check();
        const std::uint32_t block = set.source[i].block;
        tree::BlockEdit change{set.blockNumber[block], {}, {}};
        surfel::MutableBlockPtr changed;
        for (; i < set.oldCount() && set.source[i].block == block; ++i) {
            const int slot = set.source[i].slot;
            if (set.is(i, Gone))
                change.removed.set(static_cast<std::size_t>(slot));
            if (at[i] < 0)
                continue;
            if (!changed)
                changed = set.block[block]->clone();
            const Settled& s = settled[static_cast<std::size_t>(at[i])];
            changed->set(slot, s.surfel);
            changed->setExtra(slot, s.words);
        }
        if (changed)
            changed->seal();
        change.changed = changed;
        if (changed || change.removed.any())
            edit.blocks.push_back(std::move(change));
    }
    for (std::size_t i = set.oldCount(); i < set.size(); ++i)
        if (at[i] >= 0)
            edit.inserted.append(settled[static_cast<std::size_t>(at[i])].surfel,
                                 settled[static_cast<std::size_t>(at[i])].words);
    return edit;
}

/// Those of `which` as the fit wants them.
std::vector<SampleFit::Sample> samplesOf(const SampleSet& set, const std::vector<std::uint32_t>& which,
                                         const std::vector<Settled>& all) {
    std::vector<SampleFit::Sample> out(which.size());
    for (std::size_t k = 0; k < which.size(); ++k)
        out[k] = {all[k].surfel.position, all[k].surfel.normal, set.target[which[k]]};
    return out;
}

tree::Edit fittedEditOf(const SampleSet& set, const std::vector<std::uint32_t>& which, std::vector<Settled>& all) {
    SampleFit fit(set.frozen, samplesOf(set, which, all), set.pinned);
    tree::Edit edit = editOf(set, which, all);
    for (int round = 0; round < set.options.fitRounds; ++round) {
        if (!fit.improve({set.version.tree().apply(edit), set.frozen.definition()}))
            break;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (fit.changed(k))
                all[k].surfel.position = fit.position(k), all[k].surfel.normal = fit.normal(k);
        edit = editOf(set, which, all);
    }
    return edit;
}

} // namespace

tree::Edit settle(SampleSet& set) {
    std::vector<Landing> landings;
    const std::vector<std::uint32_t> which = landAll(set, landings);
    std::vector<base::Vec3f> places(landings.size());
    for (std::size_t k = 0; k < places.size(); ++k)
        places[k] = landings[k].place;
    const Blender blender(set.frozen, set.spacing, places);
    std::vector<Settled> all(which.size());
    base::parallelChunks(which.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        Blender::Near near;
        for (std::size_t k = begin; k < end; ++k)
            all[k] = settled(set, which[k], landings[k], blender, near);
    });
    return set.options.fitRounds > 0 && !which.empty() ? fittedEditOf(set, which, all) : editOf(set, which, all);
}

} // namespace process
