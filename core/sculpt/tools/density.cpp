#include "core/sculpt/tools/density.h"

#include "core/sculpt/tools/density_aims.h"
#include "core/sculpt/tools/dues.h"
#include "core/sculpt/tools/inside.h"
#include "core/sculpt/tools/settled.h"
#include "core/surfel/shape.h"

#include <limits>

namespace sculpt {

/// A dab of full strength changes the spacing by at most this: filling looks for room one spacing away, not ten.
constexpr float largestChange = 1.5f;
/// What stays inside the rim, in spacings.
constexpr float margin = 1.5f;
/// Supports under a brush that differ by less are one.
constexpr float even = 1.2f;
/// So many surfels have their turn in a dab of a stroke.
constexpr std::size_t atOnce = 1200;
/// What turns make coarser loses one of such pairs, in spacings, and is filled again: a step of 1.5 leaves none closer
/// than two thirds, and few turns would not push any that near.
constexpr float thinning = 0.75f;
/// Where so many lie in blocks under the brush they have turns.
constexpr std::size_t wide = 5000;

constexpr ToolParameter parameters[] = {
    {"factor", "Factor", "", "Spacing that the stroke leaves, as a fraction of what it found.", 0.6, 0.25, 1.0},
};

namespace {

struct DensityMemory : ToolMemory {
    surface::Surface began;
    Found found;
    Settled settled;
    Dues dues;
    std::vector<Dab> dabs; ///< of the stroke, as `dues` counts them
    DensityMemory(const surface::Surface& first, const Dab& dab)
        : began(first), found(first), settled(dab.centre, dab.radius), dues(dab.centre, dab.radius) {}
};

/// Do the supports under the brush differ?
bool uneven(const tree::SurfelTree& tree, const Brush& brush) {
    float least = std::numeric_limits<float>::infinity(), most = 0;
    tree.forBlocksInBall(brush.centre, brush.radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (distanceSq(block.position(slot), brush.centre) < brush.radius * brush.radius)
                least = std::min(least, block.support(slot)), most = std::max(most, block.support(slot));
    });
    return most > even * least;
}

/// Gives these surfels their graded supports, on top of what `edit` does. The others of their blocks have those that
/// they had.
tree::Edit graded(const tree::SurfelTree& tree, const tree::Selection& under, const Aims& aims, tree::Edit edit) {
    tree::Edit out;
    out.inserted = std::move(edit.inserted);
    aims.grade(out.inserted.items);
    const int shape = surfel::shapeChannel(*tree.layout());
    out.blocks.resize(under.size());
    base::parallelFor(under.size(), 8, [&](std::size_t b) {
        tree::BlockEdit& change = out.blocks[b];
        change.block = under[b].block;
        const auto found = std::lower_bound(edit.blocks.begin(), edit.blocks.end(), change.block,
                                            [](const tree::BlockEdit& e, std::uint32_t n) { return e.block < n; });
        if (found != edit.blocks.end() && found->block == change.block)
            change = *found;
        const surfel::BlockPtr before = tree.block(change.block);
        const surfel::SurfelBlock& now = change.changed ? *change.changed : *before;
        surfel::MutableBlockPtr changed;
        for (int slot = 0; slot < now.size(); ++slot) {
            const float support = under[b].slots[static_cast<std::size_t>(slot)]
                                      ? aims.support(*before, slot, now.position(slot))
                                      : before->support(slot);
            if (support == now.support(slot))
                continue;
            if (!changed)
                changed = now.clone();
            surfel::setBall(*changed, slot, shape, support);
        }
        if (changed)
            changed->seal(), change.changed = changed;
    });
    std::erase_if(out.blocks, [](const tree::BlockEdit& e) { return !e.changed && e.removed.none(); });
    return out;
}

/// Where the sampling differs: of what is under the brush those that the dab concerns, well inside of the rim for what
/// they are to become. `coarsest`: of them.
tree::Selection concerned(const tree::SurfelTree& tree, const Brush& brush, const Aims& aims, float perSpacing,
                          tree::Selection out, float& coarsest) {
    std::vector<float> most(out.size());
    base::parallelFor(out.size(), 8, [&](std::size_t i) {
        const surfel::BlockPtr block = tree.block(out[i].block);
        for (int slot = 0; slot < block->size(); ++slot) {
            const auto bit = static_cast<std::size_t>(slot);
            if (!out[i].slots[bit])
                continue;
            const float after = aims.support(*block, slot);
            const float within = brush.radius - margin * std::max(block->support(slot), after) / perSpacing;
            const bool in = distance(block->position(slot), brush.centre) < within && aims.concerns(*block, slot);
            out[i].slots.set(bit, in);
            most[i] = in ? std::max(most[i], after) : most[i];
        }
    });
    std::erase_if(out, [](const tree::SelectedBlock& each) { return each.slots.none(); });
    for (const float each : most)
        coarsest = std::max(coarsest, each / perSpacing);
    return out;
}

/// One dab, or what it has left.
class DensityDab {
  public:
    /// `left`: the number of a dab that comes again for that.
    DensityDab(const surface::Surface& version, const surface::Surface& began, const Dab& dab, DensityMemory& memory,
               std::optional<int> left)
        : m_version(version), m_began(began), m_tree(version.tree()), m_dab(dab), m_memory(memory), m_left(left),
          m_brush(dab), m_perSpacing(process::supportOf(version.definition(), 1.0f)),
          m_oneSupport(version.definition().support > 0), m_strength(std::abs(dab.strength)) {}

    tree::Edit run() {
        m_first = process::localSpacing(m_began, m_dab.centre);
        m_present = process::localSpacing(m_version, m_dab.centre);
        if (m_dab.strength == 0 || !(m_first > 0) || !(m_present > 0)) {
            if (m_left)
                m_memory.dues.forgive(*m_left);
            return {};
        }
        const float parameter = m_dab.parameter("factor");
        m_factor = m_dab.strength < 0 ? 1 / parameter : parameter;
        m_goal = m_dab.strength < 0 ? m_first / parameter : m_first * parameter;
        if (!m_oneSupport)
            m_goal = std::min(m_goal, m_first + grading * 0.5f * m_dab.radius / m_perSpacing);
        m_options.relaxAll = true;
        m_byTurns = m_left || isWide();
        // A turn is one of few and fills twice, or what is wide would end coarser than what is narrow.
        if (m_dab.strength > 0 && !m_byTurns)
            m_options.order = process::Order::RelaxFirst;
        if (m_byTurns && m_dab.strength < 0)
            m_options.merge = thinning;
        return !m_oneSupport && uneven(m_began.tree(), m_brush) ? byPlaces() : byOneAim();
    }

  private:
    static float changeOf(float strength) { return std::pow(largestChange, strength); }
    float stepFrom(float present, float strength) const {
        return std::clamp(m_goal, present / changeOf(strength), present * changeOf(strength));
    }
    Aim aimAt(float spacing) const {
        return {m_dab.centre, m_dab.radius, m_first * m_perSpacing,
                process::supportOf(m_version.definition(), spacing)};
    }
    /// Are there far more under the brush than have their turn at once? A dab alone does all, and so does one whose
    /// surfels are known by the version.
    bool isWide() const {
        std::size_t under = 0;
        if (m_dab.memory && !m_dab.connected && !m_oneSupport)
            m_tree.forBlocksInBall(m_brush.centre, m_brush.radius,
                                   [&](std::uint32_t, const surfel::SurfelBlock& block) {
                                       under += static_cast<std::size_t>(block.size());
                                   });
        return under > wide;
    }
    /// What the dab does of what it owes, or what it has left of that. `aims`: of the stroke.
    template <class Which>
    Dues::Turn turn(bool alike, const Aims& goals, const Which& which) {
        const auto look = [&](const Dues::Cell& cell) {
            Dues::Seen out;
            out.under = inside(m_tree, m_brush, m_brush.radius, cell.surfels);
            float within = 0;
            out.which = which(out.under, within);
            out.there = allReached(out.which, goals);
            out.whole = distance(cell.middle, m_brush.centre) + cell.reach < within;
            return out;
        };
        const int atGoal = m_dab.strength > 0 ? 1 : 3; // fewer every time, and cheaper
        const Dues::Wanted wanted{m_tree, atOnce, atGoal, alike, look};
        if (m_left)
            return m_memory.dues.rest(*m_left, wanted);
        Dab& kept = m_memory.dabs.emplace_back(m_dab);
        kept.first = nullptr, kept.past = {}, kept.layers = nullptr; // the stroke's, for as long as the dab
        m_memory.dues.owe(m_tree, m_dab.centre, m_dab.radius, m_strength);
        return m_memory.dues.next(wanted);
    }
    bool allReached(const tree::Selection& which, const Aims& goals) const {
        for (const tree::SelectedBlock& each : which) {
            const surfel::BlockPtr block = m_tree.block(each.block);
            for (int slot = 0; slot < block->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)] && !goals.reached(*block, slot))
                    return false;
        }
        return true;
    }

    /// The brush without its rim, for a step from the spacing `present`.
    float withinFor(float present, float strength) const {
        // Coarse sampling begins only where the supports are wide enough for it.
        const float spacing = stepFrom(present, strength);
        const Aim aim = aimAt(spacing);
        const float ramp = m_oneSupport ? 0.0f : std::max(0.0f, aim.to - aim.from) / grading;
        return m_dab.radius - std::max(ramp, margin * std::max(present, spacing));
    }
    /// Where the stroke found an even sampling.
    tree::Edit byOneAim() {
        const Aims goals(aimAt(m_goal));
        Dues::Turn now{{}, {}, m_strength, 0};
        if (m_byTurns) {
            // of what comes to more than one dab at once, and began anywhere between start and goal
            const float within = std::min(withinFor(m_first, 1), withinFor(m_goal, 1));
            now = turn(true, goals, [&](const tree::Selection& under, float& whole) {
                return inside(m_tree, m_brush, whole = within, under);
            });
        } else {
            const float within = withinFor(m_present, m_strength);
            now.under = inside(m_tree, m_brush, m_brush.radius);
            now.which = inside(m_tree, m_brush, within);
            if (!m_oneSupport)
                now.which = m_memory.settled.drop(
                    m_tree, std::move(now.which), {m_dab.centre, within},
                    [&](const surfel::SurfelBlock& block, int slot) { return goals.reached(block, slot); });
        }
        const float present = now.support > 0 ? process::spacingOf(m_version.definition(), now.support) : m_present;
        m_options.spacing = stepFrom(present, now.strength);
        m_options.support = process::supportOf(m_version.definition(), m_options.spacing);
        tree::Edit edit = process::resample(m_version, now.which, m_options);
        return m_oneSupport ? edit : graded(m_tree, now.under, Aims(aimAt(m_options.spacing)), std::move(edit));
    }

    /// Each place to its own aim.
    tree::Edit byPlaces() {
        Found& found = m_memory.found;
        const float factor = m_factor / process::reachByChance(m_began, m_dab.centre);
        const auto aimsOf = [&](float strength) {
            return Aims(aimAt(stepFrom(m_present, strength)), found, factor, changeOf(strength));
        };
        const Aims goals(aimAt(m_goal), found, factor, std::numeric_limits<float>::infinity());
        float coarsest = 0;
        Dues::Turn now{{}, {}, m_strength, 0};
        if (m_byTurns) {
            const Aims most = aimsOf(1);
            now = turn(false, goals, [&](const tree::Selection& under, float& whole) {
                std::vector<surfel::BlockPtr> blocks;
                for (const tree::SelectedBlock& each : under)
                    blocks.push_back(m_tree.block(each.block));
                found.measure(blocks);
                float here = 0;
                tree::Selection which = concerned(m_tree, m_brush, most, m_perSpacing, under, here);
                whole = m_brush.radius - margin * here;
                coarsest = std::max(coarsest, here);
                return which;
            });
        } else {
            found.measure(blocksAround(m_tree, m_brush.centre, m_brush.radius));
            now.under = inside(m_tree, m_brush, m_brush.radius);
            now.which = concerned(m_tree, m_brush, aimsOf(m_strength), m_perSpacing, now.under, coarsest);
            now.which = m_memory.settled.drop(
                m_tree, std::move(now.which), {m_brush.centre, m_brush.radius - margin * coarsest},
                [&](const surfel::SurfelBlock& block, int slot) { return goals.reached(block, slot); });
        }
        m_options.spacing = coarsest;
        measureAround(now.which);
        const Aims aims = aimsOf(now.strength);
        m_options.targetOf = [&](const surfel::SurfelBlock& block, int slot) {
            return aims.support(block, slot) / m_perSpacing;
        };
        return graded(m_tree, now.under, aims,
                      process::resample(m_version, now.which, m_options)); // supports follow in `graded`
    }
    /// What resampling of these will look at. Of the rest, what the brush may come to again is kept.
    void measureAround(const tree::Selection& which) {
        const float around = inTheWay * m_options.spacing;
        m_memory.found.known.keepOnly(blocksAround(m_tree, m_brush.centre, m_brush.radius + around));
        std::map<std::uint32_t, surfel::BlockPtr> near;
        for (const tree::SelectedBlock& each : which) {
            const base::Box3f box = m_tree.block(each.block)->box();
            m_tree.forBlocksInBall(box.centre(), 0.5f * box.diagonal() + around,
                                   [&](std::uint32_t number, const surfel::SurfelBlock&) {
                                       near.try_emplace(number, m_tree.block(number));
                                   });
        }
        std::vector<surfel::BlockPtr> blocks;
        for (const auto& [number, block] : near)
            blocks.push_back(block);
        m_memory.found.measure(blocks);
    }

    const surface::Surface &m_version, &m_began;
    const tree::SurfelTree& m_tree;
    const Dab& m_dab;
    DensityMemory& m_memory;
    const std::optional<int> m_left;
    const Brush m_brush;
    const float m_perSpacing;
    const bool m_oneSupport;
    const float m_strength;
    bool m_byTurns = false;
    float m_first = 0, m_present = 0, m_factor = 1, m_goal = 0; ///< spacings at the centre; of the stroke
    process::ResampleOptions m_options;
};

} // namespace

static tree::Edit density(const surface::Surface& version, const Dab& dab) {
    const surface::Surface& began = dab.first ? *dab.first : version;
    std::unique_ptr<ToolMemory> once;
    auto& memory = memoryOf<DensityMemory>(dab, once, began, dab);
    return DensityDab(version, began, dab, memory, {}).run();
}

/// What the dabs have left, a part of it.
static tree::Edit densityRest(const surface::Surface& version, ToolMemory& stroke) {
    auto& memory = static_cast<DensityMemory&>(stroke);
    while (const std::optional<int> left = memory.dues.firstDab()) {
        const Dab& dab = memory.dabs[static_cast<std::size_t>(*left)];
        tree::Edit edit = DensityDab(version, memory.began, dab, memory, left).run();
        if (!edit.empty())
            return edit;
    }
    return {};
}

const ToolRow densityTool{"density",
                          "Density",
                          "icons/tool-density.svg",
                          "",
                          "Makes the sampling finer where it is too coarse for detail; inverted, coarser.",
                          Motion::Along,
                          1.0,
                          parameters,
                          density,
                          Writes::Count,
                          {},
                          densityRest};

} // namespace sculpt
