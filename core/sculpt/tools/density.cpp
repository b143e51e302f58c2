#include "core/sculpt/tools/density.h"

#include "core/base/parallel.h"
#include "core/process/estimation/chance.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/block_memo.h"
#include "core/sculpt/tools/inside.h"
#include "core/sculpt/tools/settled.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sculpt {

/// A dab of full strength changes the spacing by at most this: filling looks for room one spacing away, not ten.
constexpr float largestChange = 1.5f;
/// How fast supports may change over distance (sculpt/README 6.4).
constexpr float grading = 0.5f;
/// What stays inside the rim, in spacings.
constexpr float margin = 1.5f;
/// Where the stroke found a sampling that differs by more than this from the centre's, a dab does less and less, up to
/// where it does nothing: searches reach as far as the coarsest asks, and there the stroke has not come yet.
constexpr float alike = 1.6f, unlike = 2.5f;
/// So near to what a stroke is to leave, in parts of it, a surfel has its support.
constexpr float near = 0.04f;
/// Supports under a brush that differ by less are one.
constexpr float even = 1.2f;

constexpr ToolParameter parameters[] = {
    {"factor", "Factor", "", "Spacing that the stroke leaves, as a fraction of what it found.", 0.6, 0.25, 1.0},
};

namespace {

/// What the dab aims at.
struct Aim {
    base::Vec3f centre;
    float radius;
    float from, to; ///< supports: where the stroke began, and after this dab in the middle

    /// The graded support of a surfel that had `present`; it goes towards the aim or stays.
    float support(const base::Vec3f& p, float present) const {
        const float room = grading * std::max(0.0f, radius - distance(p, centre));
        return to < from ? std::min(present, std::max(to, from - room)) : std::max(present, std::min(to, from + room));
    }
};

/// Supports where the stroke began, and what it has found of them around the surfels that the last dab looked at.
struct Found {
    process::SpacingField field;
    BlockMemo<float> known;

    explicit Found(const surface::Surface& began) : field(began.tree(), 1.0f) {}
    void measure(std::span<const surfel::BlockPtr> blocks) {
        known.measure(blocks, [&] {
            return [search = process::SpacingField::Search(field)](
                       const surfel::SurfelBlock& block, std::span<const int> slots, std::span<float> out) mutable {
                std::array<base::Vec3f, surfel::clusterSize> places;
                for (std::size_t i = 0; i < slots.size(); ++i)
                    places[i] = block.position(slots[i]);
                search.at(std::span(places).first(slots.size()), out);
            };
        });
    }
    float at(const surfel::SurfelBlock& block, int slot) const {
        const float* const has = known.find(block, slot);
        return has ? *has : field.at(block.position(slot));
    }
};

struct DensityMemory : ToolMemory {
    Found found;
    Settled settled;
    DensityMemory(const surface::Surface& began, const Dab& dab) : found(began), settled(dab.centre, dab.radius) {}
};

/// The aims of a dab, place by place: where the stroke found an even sampling, one for all.
class Aims {
  public:
    explicit Aims(const Aim& same) : m_middle(same) {}
    /// `middle`: of the centre. `found`: where the stroke began. `factor`: what is left of the supports there.
    /// `change`: by as much at once.
    Aims(const Aim& middle, const Found& found, float factor, float change)
        : m_middle(middle), m_found(&found), m_factor(factor), m_change(change) {}

    /// Of a surfel that has the support `present`, where the stroke found the support `from`.
    Aim at(float from, float present) const {
        if (!m_found)
            return m_middle;
        const float goal = from * std::pow(m_factor, share(from));
        const float most = from + grading * 0.5f * m_middle.radius; // what half the radius has room for
        return {m_middle.centre, m_middle.radius, from,
                std::clamp(std::min(goal, most), present / m_change, present * m_change)};
    }
    bool concerns(const surfel::SurfelBlock& block, int slot) const {
        return !m_found || share(m_found->at(block, slot)) > 0;
    }
    /// What the dab leaves of a surfel's support. It counts as being at p.
    float support(const surfel::SurfelBlock& block, int slot, const base::Vec3f& p) const {
        const float present = block.support(slot);
        if (!m_found)
            return m_middle.support(p, present);
        const float from = m_found->at(block, slot);
        return share(from) > 0 ? at(from, present).support(p, present) : present;
    }
    float support(const surfel::SurfelBlock& block, int slot) const {
        return support(block, slot, block.position(slot));
    }
    bool reached(const surfel::SurfelBlock& block, int slot) const {
        const float present = block.support(slot);
        return std::abs(support(block, slot) - present) < near * present;
    }
    /// And of those that are new, in parallel.
    void grade(std::span<surfel::Surfel> born) const {
        base::parallelChunks(born.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            const std::span<surfel::Surfel> some = born.subspan(begin, end - begin);
            std::vector<float> from(some.size(), 0.0f);
            if (m_found) {
                std::vector<base::Vec3f> places(some.size());
                for (std::size_t i = 0; i < some.size(); ++i)
                    places[i] = some[i].position;
                process::SpacingField::Search(m_found->field).at(places, from);
            }
            for (std::size_t i = 0; i < some.size(); ++i) {
                const Aim aim = at(from[i], some[i].support);
                some[i].support = aim.support(some[i].position, aim.from);
            }
        });
    }

  private:
    /// How much a dab does where the stroke found this support: 1 where it is like the centre's.
    float share(float from) const {
        const float apart = std::abs(std::log(from / m_middle.from));
        return std::clamp((std::log(unlike) - apart) / std::log(unlike / alike), 0.0f, 1.0f);
    }

    Aim m_middle;
    const Found* m_found = nullptr; ///< null: one for all
    float m_factor = 1, m_change = 1;
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

/// Gives all that is under the brush and stays its graded support, on top of what `edit` does.
tree::Edit graded(const tree::SurfelTree& tree, const Brush& brush, const Aims& aims, tree::Edit edit) {
    tree::Edit out;
    out.inserted = std::move(edit.inserted);
    aims.grade(out.inserted.items);
    std::vector<BrushBlock> blocks = blocksUnder(tree, brush.centre, brush.radius);
    const int shape = surfel::shapeChannel(*tree.layout());
    out.blocks.resize(blocks.size());
    base::parallelFor(blocks.size(), 8, [&](std::size_t b) {
        tree::BlockEdit& change = out.blocks[b];
        change.block = blocks[b].number;
        const auto found = std::lower_bound(edit.blocks.begin(), edit.blocks.end(), change.block,
                                            [](const tree::BlockEdit& e, std::uint32_t n) { return e.block < n; });
        if (found != edit.blocks.end() && found->block == change.block)
            change = *found;
        const surfel::SurfelBlock& now = change.changed ? *change.changed : *blocks[b].block;
        surfel::MutableBlockPtr changed;
        alignas(64) float weight[lanes];
        for (int slot = 0; slot < now.size(); ++slot) {
            if (slot % surfel::clusterSize == 0)
                brush.weigh(blocks[b], slot / surfel::clusterSize, weight);
            const float support = weight[slot % surfel::clusterSize] > 0
                                      ? aims.support(*blocks[b].block, slot, now.position(slot))
                                      : blocks[b].block->support(slot);
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

/// Where the sampling differs: those that the dab concerns, well inside of the rim for what they are to become.
/// `coarsest`: of them.
tree::Selection concerned(const tree::SurfelTree& tree, const Brush& brush, const Aims& aims, float perSpacing,
                          float& coarsest) {
    tree::Selection out = inside(tree, brush, brush.radius);
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

/// Each place to its own aim.
tree::Edit byPlaces(const surface::Surface& version, const Brush& brush, const Aims& aims, const Aims& goals,
                    DensityMemory& memory, process::ResampleOptions options) {
    Found& found = memory.found;
    const tree::SurfelTree& tree = version.tree();
    const float perSpacing = process::supportOf(version.definition(), 1.0f);
    std::vector<surfel::BlockPtr> around = blocksAround(tree, brush.centre, brush.radius);
    found.measure(around);
    options.spacing = options.support = 0; // supports follow in `graded`
    const tree::Selection which =
        memory.settled.drop(tree, concerned(tree, brush, aims, perSpacing, options.spacing),
                            {brush.centre, brush.radius - margin * options.spacing},
                            [&](const surfel::SurfelBlock& block, int slot) { return goals.reached(block, slot); });
    around = blocksAround(tree, brush.centre, brush.radius + inTheWay * options.spacing);
    found.known.keepOnly(around);
    found.measure(around);
    options.targetOf = [&](const surfel::SurfelBlock& block, int slot) {
        return aims.support(block, slot) / perSpacing;
    };
    return graded(tree, brush, aims, process::resample(version, which, options));
}

} // namespace

static tree::Edit density(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const surface::SurfaceDefinition& definition = version.definition();
    const surface::Surface& began = dab.first ? *dab.first : version;
    const float first = process::localSpacing(began, dab.centre);
    const float present = process::localSpacing(version, dab.centre);
    if (dab.strength == 0 || !(first > 0) || !(present > 0))
        return {};
    const float parameter = dab.parameter("factor"), factor = dab.strength < 0 ? 1 / parameter : parameter;
    const float perSpacing = process::supportOf(definition, 1.0f);
    const bool oneSupport = definition.support > 0;
    float goal = dab.strength < 0 ? first / parameter : first * parameter;
    if (!oneSupport)
        goal = std::min(goal, first + grading * 0.5f * dab.radius / perSpacing);
    const float change = std::pow(largestChange, std::abs(dab.strength));
    process::ResampleOptions options;
    options.spacing = std::clamp(goal, present / change, present * change);
    options.support = process::supportOf(definition, options.spacing);
    options.relaxAll = true;
    if (dab.strength > 0)
        options.order = process::Order::RelaxFirst;
    const Aim aim{dab.centre, dab.radius, process::supportOf(definition, first), options.support};
    const Aim end{dab.centre, dab.radius, aim.from, process::supportOf(definition, goal)};
    std::unique_ptr<ToolMemory> once;
    auto& memory = memoryOf<DensityMemory>(dab, once, began, dab);
    if (!oneSupport && uneven(began.tree(), brush)) {
        const float reach = process::reachByChance(began, dab.centre);
        const Found& found = memory.found;
        return byPlaces(version, brush, Aims(aim, found, factor / reach, change),
                        Aims(end, found, factor / reach, std::numeric_limits<float>::infinity()), memory, options);
    }
    // Coarse sampling begins only where the supports are wide enough for it.
    const float ramp = oneSupport ? 0.0f : std::max(0.0f, aim.to - aim.from) / grading;
    const float within = dab.radius - std::max(ramp, margin * std::max(present, options.spacing));
    tree::Selection which = inside(version.tree(), brush, within);
    if (!oneSupport)
        which = memory.settled.drop(
            version.tree(), std::move(which), {dab.centre, within},
            [&, goals = Aims(end)](const surfel::SurfelBlock& block, int slot) { return goals.reached(block, slot); });
    tree::Edit edit = process::resample(version, which, options);
    return oneSupport ? edit : graded(version.tree(), brush, Aims(aim), std::move(edit));
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
                          Writes::Count};

} // namespace sculpt
