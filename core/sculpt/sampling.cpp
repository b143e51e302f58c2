#include "core/sculpt/sampling.h"

#include "core/cells/flat_pairs.h"
#include "core/layers/layer_edits.h"
#include "core/process/resampling/refine_under.h"
#include "core/sculpt/crumbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace sculpt {

/// Where more surfels than are done at once are beyond these, it is time to begin.
constexpr StretchRange nearlyDue{0.6f, 1.5f};
/// Beyond these nothing may wait, however many there are.
constexpr StretchRange mustBeyond{0.4f, 2.4f};
/// Around a surfel that is asked for, what moved is done with it so far, in spacings: a tear along the rim of a brush.
constexpr float tearReach = 2.5f;
/// Targets that differ by more than this are seen to one after the other: searches reach as far as the largest asks.
constexpr float classWidth = 2.5f;
/// Around what a tool took away, in spacings.
constexpr float crumbsReach = 8;
/// Two even the sampling nearly as well as three.
constexpr int sweeps = 2;
/// Balls are united while that makes none larger than this.
constexpr float unitedGrowth = 1.25f;

void Sampling::start(const surface::Surface& surface, const base::Vec3f& contact, bool graded,
                     std::shared_ptr<const layers::Stack> stack) {
    m_layers = std::move(stack);
    m_graded = graded && surface.definition().support <= 0;
    m_spacing = process::localSpacing(surface, contact);
    m_kept = {surface, m_spacing};
}

bool restructures(const tree::Edit& edit) {
    return !edit.inserted.items.empty() ||
           std::any_of(edit.blocks.begin(), edit.blocks.end(), [](const auto& each) { return each.removed.any(); });
}

void Sampling::refined(const tree::SurfelTree& before, const surface::Surface& after, const base::Vec3f& centre,
                       float radius) {
    if (!started())
        return;
    m_stretches.follow(before, after.tree());
    // the version that the stroke began on, had it been refined then
    if (const auto first = process::refinedUnder(m_kept.first(), centre, radius))
        m_kept = {*first, m_spacing};
    m_spacing = std::min(m_spacing, process::localSpacing(after, centre));
}

void Sampling::note(const tree::SurfelTree& before, const tree::Edit& edit, const Dab& dab) {
    if (edit.empty() || !started())
        return;
    const float move = m_stretches.note(before, edit);
    if (move == 0 && !restructures(edit))
        return; // colours and masks ask for no other sampling
    m_range = m_stretches.range();
    m_waiting = m_graded ? 0 : m_stretches.beyond(nearlyDue);
    m_ending = Ending::Open;
    add({dab.centre + dab.move * 0.5f, dab.radius + move});
}

void Sampling::noteCount(const tree::Edit& edit, const Dab& dab) {
    if (edit.empty() || !started())
        return;
    m_counts = true;
    m_ending = Ending::Open;
    add({dab.centre, dab.radius});
}

void Sampling::add(Ball ball) {
    if (!m_balls.empty()) {
        Ball& last = m_balls.back();
        const base::Vec3f apart = ball.centre - last.centre;
        const float gap = length(apart), united = 0.5f * (gap + ball.radius + last.radius);
        if (gap + ball.radius <= last.radius)
            return;
        if (gap + last.radius <= ball.radius) {
            last = ball;
            return;
        }
        if (united <= unitedGrowth * ball.radius) {
            last = {last.centre + apart * ((united - last.radius) / gap), united};
            return;
        }
    }
    m_balls.push_back(ball);
}

tree::Selection Sampling::touched(const tree::SurfelTree& tree, float margin) const {
    std::map<std::uint32_t, std::bitset<surfel::blockCapacity>> all;
    for (const Ball& each : m_balls) {
        const Ball ball{each.centre, each.radius + margin};
        tree.forBlocksInBall(ball.centre, ball.radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            auto& slots = all[number];
            if (slots.count() == static_cast<std::size_t>(block.size()))
                return;
            for (int slot = 0; slot < block.size(); ++slot)
                if (distanceSq(block.position(slot), ball.centre) < ball.radius * ball.radius)
                    slots.set(static_cast<std::size_t>(slot));
        });
    }
    tree::Selection out;
    for (const auto& [number, slots] : all)
        if (slots.any())
            out.push_back({number, slots});
    return out;
}

tree::SurfelTree Sampling::resampled(const surface::Surface& surface, const tree::Selection& which,
                                     const process::ResampleOptions& options) const {
    tree::Edit edit = process::resample(surface, which, options);
    if (m_layers)
        edit = layers::carried(surface.tree(), std::move(edit), *m_layers);
    return surface.tree().apply(edit);
}

/// All that was touched, with the targets of its supports: those of similar ones together, finest first.
surface::Surface Sampling::evened(surface::Surface surface, When when) const {
    const float perSupport = process::spacingOf(surface.definition(), 1.0f);
    process::ResampleOptions options;
    options.sweeps = sweeps;
    if (when == When::During)
        options.fitRounds = 0;
    options.field = std::make_shared<process::SpacingField>(surface.tree(), perSupport);
    for (float from = 0; from < std::numeric_limits<float>::infinity();) {
        tree::Selection some = touched(surface.tree());
        float least = std::numeric_limits<float>::infinity(), most = 0;
        const auto forEach = [&](const auto& fn) {
            for (tree::SelectedBlock& each : some) {
                const surfel::BlockPtr block = surface.tree().block(each.block);
                for (int slot = 0; slot < block->size(); ++slot)
                    if (each.slots[static_cast<std::size_t>(slot)])
                        fn(each, slot, perSupport * m_kept.supportOf(*block, slot));
            }
        };
        forEach([&](tree::SelectedBlock&, int, float target) {
            if (target > from)
                least = std::min(least, target);
        });
        const float upTo = least * classWidth;
        forEach([&](tree::SelectedBlock& each, int slot, float target) {
            const bool in = target > from && target <= upTo;
            each.slots.set(static_cast<std::size_t>(slot), in);
            most = in ? std::max(most, target) : most;
        });
        std::erase_if(some, [](const tree::SelectedBlock& each) { return each.slots.none(); });
        options.spacing = most;
        if (!some.empty())
            surface = {resampled(surface, some, options), surface.definition()};
        from = upTo;
    }
    return surface;
}

LocalSpacing Sampling::measuredOf(const Stretches::Tracked& each, int slot) const {
    const auto s = static_cast<std::size_t>(slot);
    return each.spacing.empty() || !each.spacing[s].known ? m_kept.measured(*each.origin, slot) : each.spacing[s];
}

float Sampling::targetOf(const Stretches::Tracked& each, int slot) const {
    return m_kept.target(measuredOf(each, slot), m_kept.supportOf(*each.now, slot));
}

float Sampling::targetOf(const surfel::SurfelBlock& block, int slot) const {
    const Stretches::Tracked* known = m_stretches.find(block);
    return known ? targetOf(*known, slot) : m_kept.target(m_kept.measured(block, slot), m_kept.supportOf(block, slot));
}

void Sampling::measureTracked(const Which& which) {
    m_stretches.measureWhere(which, [&] {
        return [&, search = KeptSpacing::Search(m_kept)](const surfel::SurfelBlock& origin, std::span<const int> slots,
                                                         std::span<LocalSpacing> out) mutable {
            m_kept.measured(origin, slots, search, out);
        };
    });
}

/// Measures what resampling of the surfels asked for will look at.
void Sampling::measureAround(const tree::SurfelTree& tree) {
    measureTracked([](const Stretches::Tracked& each) { return each.asked; });
    std::set<std::uint32_t> numbers;
    m_stretches.forEach([&](const Stretches::Tracked& each) {
        base::Box3f box;
        float most = 0;
        for (int slot = 0; slot < each.now->size(); ++slot)
            if (each.asked[static_cast<std::size_t>(slot)])
                box.extend(each.now->position(slot)), most = std::max(most, targetOf(each, slot));
        if (most > 0)
            tree.forBlocksInBall(box.centre(), 0.5f * box.diagonal() + inTheWay * most,
                                 [&](std::uint32_t number, const surfel::SurfelBlock&) { numbers.insert(number); });
    });
    std::vector<surfel::BlockPtr> resting;
    std::set<const surfel::SurfelBlock*> moving;
    for (const std::uint32_t number : numbers) {
        const surfel::BlockPtr block = tree.block(number);
        if (m_stretches.find(*block))
            moving.insert(block.get());
        else
            resting.push_back(block);
    }
    measureTracked([&](const Stretches::Tracked& each) {
        return moving.contains(each.now.get()) ? Stretches::Slots().set() : Stretches::Slots();
    });
    m_kept.measure(resting);
}

/// About `count` of the surfels asked for, of similar targets, the finest first. False: none is left.
bool Sampling::resampleSome(surface::Surface& surface, std::size_t count, When when) {
    measureAround(surface.tree());
    float least = std::numeric_limits<float>::infinity();
    m_stretches.forEach([&](const Stretches::Tracked& each) {
        for (int slot = 0; slot < each.now->size(); ++slot)
            if (each.asked[static_cast<std::size_t>(slot)])
                least = std::min(least, targetOf(each, slot));
    });
    const float upTo = least * classWidth;
    const tree::Selection taken = m_stretches.take(
        surface.tree(), [&](const Stretches::Tracked& each, int slot) { return targetOf(each, slot) <= upTo; }, count);
    if (taken.empty())
        return false;
    const surface::Surface next = resampleClass(surface, taken, when);
    m_stretches.follow(surface.tree(), next.tree());
    surface = next;
    return true;
}

surface::Surface Sampling::resampleClass(const surface::Surface& surface, const tree::Selection& taken, When when) {
    process::ResampleOptions options;
    options.sweeps = sweeps;
    if (when == When::During)
        options.fitRounds = 0;
    float least = std::numeric_limits<float>::infinity();
    for (const tree::SelectedBlock& each : taken) {
        const surfel::BlockPtr block = surface.tree().block(each.block);
        for (int slot = 0; slot < block->size(); ++slot)
            if (each.slots[static_cast<std::size_t>(slot)]) {
                const float target = targetOf(*block, slot);
                least = std::min(least, target), options.spacing = std::max(options.spacing, target);
            }
    }
    if (options.spacing != least || options.spacing != m_spacing)
        options.targetOf = [this](const surfel::SurfelBlock& block, int slot) { return targetOf(block, slot); };
    options.drawnApart = [this](const surfel::SurfelBlock& block, int slot) {
        const Stretches::Tracked* known = m_stretches.find(block);
        return known && known->drawn[static_cast<std::size_t>(slot)];
    };
    return {resampled(surface, taken, options), surface.definition()};
}

/// An edge that the stroke turns into a groove ends its sides elsewhere: resampling goes by signs as they are now.
/// Until the end surfels keep their partners: an edge that is flat for a while is one again after it.
surface::Surface Sampling::resampleDue(const surface::Surface& surface) {
    surface::Surface out = withLabels(surface, m_labelled, cells::Partners::Kept);
    m_labelled = m_balls.empty() ? 0 : m_balls.size() - 1; // the last one may grow
    if (m_graded) {
        m_stretches.ask(doneBeyond);
        m_stretches.take(out.tree(), [](const Stretches::Tracked&, int) { return true; });
        out = evened(out, When::During);
    } else {
        m_stretches.askMost(out.tree(), doneBeyond, mustBeyond, atOnce);
        while (resampleSome(out, std::numeric_limits<std::size_t>::max(), When::During)) {
        }
    }
    m_range = m_stretches.range();
    m_waiting = m_graded ? 0 : m_stretches.beyond(nearlyDue);
    return out;
}

void Sampling::askAtTheEnd(const surface::Surface& surface) {
    m_stretches.askWhere(
        [&](const Stretches::Tracked& each, int slot, const StretchRange& range) {
            return each.seen[static_cast<std::size_t>(slot)] || !range.within(doneBeyond);
        },
        doneBeyond.most);
    askForDrift(surface);
    m_stretches.askAround(surface.tree(),
                          [&](const Stretches::Tracked& each, int slot) { return tearReach * targetOf(each, slot); });
}

tree::Selection Sampling::mayBeCrumbs(const tree::SurfelTree& tree) const {
    if (m_counts)
        return touched(tree, crumbsReach * m_spacing);
    tree::Selection out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const Stretches::Tracked* known = m_stretches.find(block);
        if (known && known->seen.any())
            out.push_back(
                {number, (Stretches::Slots().set() >> static_cast<std::size_t>(surfel::blockCapacity - block.size()))});
    });
    return out;
}

surface::Surface Sampling::withoutCrumbs(const surface::Surface& surface) {
    const tree::Selection candidates = mayBeCrumbs(surface.tree());
    std::vector<surfel::BlockPtr> resting; // slot after slot costs a third of one by one
    for (const tree::SelectedBlock& each : candidates)
        if (const surfel::BlockPtr block = surface.tree().block(each.block); !m_stretches.find(*block))
            resting.push_back(block);
    m_kept.measure(resting);
    const tree::Edit edit =
        dropCrumbs(surface.tree(), m_kept.first().tree(), candidates, [&](const surfel::SurfelBlock& block, int slot) {
            const Stretches::Tracked* known = m_stretches.find(block);
            return CrumbSource{(known ? *known->origin : block).position(slot), targetOf(block, slot),
                               m_kept.madeFor(m_kept.supportOf(block, slot))};
        });
    return {surface.tree().apply(edit), surface.definition()};
}

/// Of models with cells: signs in these balls, and partners where they are to be measured, as surfels lie now.
surface::Surface Sampling::withLabels(const surface::Surface& surface, std::size_t firstBall,
                                      cells::Partners partners) {
    std::vector<cells::EditedBall> balls;
    for (std::size_t k = firstBall; k < m_balls.size(); ++k)
        balls.push_back({m_balls[k].centre, m_balls[k].radius});
    surface::Surface out = surface;
    const auto apply = [&](const tree::Edit& edit) {
        if (edit.empty())
            return;
        m_stretches.note(out.tree(), edit); // the same surfels in other blocks
        out = {out.tree().apply(edit), out.definition()};
    };
    apply(cells::measuredLabels(out, balls, partners));
    if (partners == cells::Partners::Measured && !m_layers) // whose strengths bring edges back
        apply(cells::mergedFlatPairs(out, balls));
    return out;
}

surface::Surface Sampling::resample(surface::Surface surface) {
    while (pending())
        surface = resampleSlice(surface);
    return surface;
}

surface::Surface Sampling::resampleSlice(const surface::Surface& surface) {
    surface::Surface out = surface;
    switch (m_ending) {
    case Ending::Open:
        m_ending = m_counts || m_graded ? Ending::Crumbs : Ending::Asked;
        if (!m_counts)
            out = withLabels(surface, m_labelled, cells::Partners::Kept);
        if (m_ending == Ending::Asked)
            askAtTheEnd(out);
        else if (!m_counts)
            out = evened(out, When::AtTheEnd);
        return out;
    case Ending::Asked:
        if (!resampleSome(out, atOnce, When::AtTheEnd))
            m_ending = Ending::Crumbs;
        return out;
    case Ending::Crumbs:
        out = withLabels(withoutCrumbs(surface), 0, cells::Partners::Measured);
        m_stretches.clear();
        m_range = {};
        m_waiting = 0;
        m_balls.clear();
        m_labelled = 0;
        m_ending = Ending::Open;
    }
    return out;
}

} // namespace sculpt
