#include "core/process/resampling/resample_fit.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"
#include "core/process/resampling/resample_set.h"
#include "core/surface/evaluation/together.h"

#include <cmath>

namespace process {

using base::Vec3f;

namespace {

/// Below this slope f says nothing about distance.
constexpr float flattest = 0.05f;
/// A surface that turns further than this from the frozen one is another sheet's, or a fold.
constexpr float leastFacing = 0.5f;
/// Farthest from where a sample began: of its spacing, and of its unit normal.
constexpr float mostRaised = 0.25f, mostTilted = 0.3f;
/// What is nearer than this is the frozen surface: of the spacing, and of a unit normal.
constexpr float noticed = 1e-4f, noticedTilt = 3e-4f;
constexpr std::size_t grain = 256;
/// Of whole models.
constexpr int rounds = 3;

struct Told {
    Vec3f gradient; ///< unit; zero: nothing is told
    float distance = 0;
};

Told toldBy(const surface::TogetherAt& e) {
    const float slope = length(e.gradient);
    if (!e.ok() && e.status != surface::Status::BeyondBoundary)
        return {};
    return slope > flattest ? Told{e.gradient / slope, e.value / slope} : Told{};
}

Vec3f shortened(const Vec3f& v, float most) {
    const float l = length(v);
    return l > most ? v * (most / l) : v;
}

} // namespace

SampleFit::SampleFit(const surface::Surface& frozen, std::vector<Sample> samples, float pinned)
    : m_start(samples.size()), m_samples(std::move(samples)), m_changed(m_samples.size()) {
    std::vector<Vec3f> places(m_samples.size()), sides(m_samples.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = m_samples[i].position, sides[i] = m_samples[i].normal;
    const bool oriented = frozen.tree().layout()->normals && frozen.tree().layout()->oriented;
    std::vector<surface::TogetherAt> at(places.size());
    surface::evaluateTogether(frozen, places, sides, at);
    base::parallelFor(places.size(), grain, [&](std::size_t i) {
        Start& start = m_start[i];
        start.place = places[i], start.normal = m_samples[i].normal;
        const surface::TogetherAt& e = at[i];
        const Told told = toldBy(e);
        if (e.offCentre > pinned * e.unit || std::abs(told.distance) > mostRaised * m_samples[i].spacing)
            return;
        const bool turned = dot(told.gradient, start.normal) < 0;
        if (turned && oriented)
            return;
        start.gradient = turned ? -told.gradient : told.gradient;
        start.distance = turned ? -told.distance : told.distance;
    });
}

bool SampleFit::improve(const surface::Surface& now) {
    const bool tilts = now.tree().layout()->normals;
    std::vector<Vec3f> places(m_start.size()), sides(m_start.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = m_start[i].place, sides[i] = m_start[i].gradient;
    m_changed.assign(m_start.size(), 0);
    std::vector<surface::TogetherAt> at(places.size());
    surface::evaluateTogether(now, places, sides, at);
    base::parallelFor(places.size(), grain, [&](std::size_t i) {
        const Start& start = m_start[i];
        Sample& sample = m_samples[i];
        if (start.gradient == Vec3f{})
            return;
        const Told told = toldBy(at[i]);
        if (dot(told.gradient, start.gradient) < leastFacing)
            return;
        const float low = told.distance - start.distance;
        const Vec3f tilt = start.gradient - told.gradient;
        if (std::abs(low) < noticed * sample.spacing && lengthSq(tilt) < noticedTilt * noticedTilt)
            return;
        if (std::abs(low) > mostRaised * sample.spacing)
            return; // another sheet's
        const float raised = dot(sample.position - start.place, start.gradient) + low;
        const float most = mostRaised * sample.spacing;
        sample.position = start.place + start.gradient * std::clamp(raised, -most, most);
        if (tilts)
            sample.normal =
                normalized(start.normal + shortened(sample.normal - start.normal + tilt, mostTilted), start.normal);
        m_changed[i] = 1;
    });
    return std::any_of(m_changed.begin(), m_changed.end(), [](std::uint8_t c) { return c != 0; });
}

namespace {

/// Which surfels of a version are fitted, by block.
struct Fitting {
    tree::Selection which;
    std::vector<std::size_t> first; ///< of each block
    std::vector<SampleFit::Sample> samples;

    Fitting(const tree::SurfelTree& tree, tree::Selection chosen, const std::function<float(const Vec3f&)>& spacingAt)
        : which(std::move(chosen)) {
        for (const tree::SelectedBlock& each : which) {
            const surfel::BlockPtr block = tree.block(each.block);
            first.push_back(samples.size());
            for (int slot = 0; slot < block->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)])
                    samples.push_back({block->position(slot), block->normal(slot), 0});
        }
        base::parallelFor(samples.size(), 256,
                          [&](std::size_t i) { samples[i].spacing = spacingAt(samples[i].position); });
    }

    /// The block with its samples as they are now; null where they are as they were.
    surfel::MutableBlockPtr changed(std::size_t k, const tree::SurfelTree& tree, const SampleFit& fit) const {
        const surfel::BlockPtr before = tree.block(which[k].block);
        surfel::MutableBlockPtr after;
        std::size_t i = first[k];
        for (int slot = 0; slot < before->size(); ++slot) {
            if (!which[k].slots[static_cast<std::size_t>(slot)])
                continue;
            const Vec3f position = fit.position(i), normal = fit.normal(i);
            ++i;
            if (before->mask(slot) >= 1 || (position == before->position(slot) && normal == before->normal(slot)))
                continue;
            if (!after)
                after = before->clone();
            after->setPosition(slot, position);
            after->setNormal(slot, normal);
        }
        if (after)
            after->seal();
        return after;
    }
};

/// From the version to the one with the samples as they are now.
tree::Edit editOf(const tree::SurfelTree& tree, const Fitting& fitting, const SampleFit& fit) {
    std::vector<surfel::BlockPtr> changed(fitting.which.size());
    base::parallelFor(changed.size(), 16, [&](std::size_t k) { changed[k] = fitting.changed(k, tree, fit); });
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    for (std::size_t k = 0; k < changed.size(); ++k)
        if (changed[k])
            edit.blocks.push_back({fitting.which[k].block, changed[k], {}});
    return edit;
}

} // namespace

tree::Edit fit(const tree::SurfelTree& tree, tree::Selection which, const surface::Surface& frozen,
               const FitOptions& options) {
    const Fitting fitting(tree, std::move(which), options.spacingAt);
    SampleFit fit(frozen, fitting.samples, options.pinned);
    tree::Edit edit;
    for (int round = 0; round < options.rounds; ++round) {
        base::CancelScope::check();
        if (!fit.improve({edit.empty() ? tree : tree.apply(edit), frozen.definition()}))
            break;
        edit = editOf(tree, fitting, fit);
    }
    return edit;
}

tree::SurfelTree fitted(const tree::SurfelTree& tree, const surface::Surface& frozen,
                        const std::function<float(const base::Vec3f&)>& spacingAt) {
    surface::SurfaceDefinition definition = frozen.definition();
    definition.shrinkFree = true; // as it is resampled (process/README 4.3)
    const tree::Edit edit =
        fit(tree, selectAll(tree), {frozen.tree(), definition}, {spacingAt, pinnedAt(definition.weight), rounds});
    return edit.empty() ? tree : tree.apply(edit);
}

} // namespace process
