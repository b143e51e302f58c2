#include "core/process/resampling/resample_set.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace process {

/// Off-centre values at which a place belongs to an open border and at which nothing grows, in units of h
/// (process/README 4.5). A straight border has 0.212 h with Wendland weights and 0.564 with the Gaussian's.
constexpr float pinnedLimit = 0.12f, grownLimit = 0.15f;
/// Where the surface goes on: a spacing beyond the last surfels before a straight border are 0.35 h.
constexpr float grownOnLimit = 0.4f;
constexpr float gaussianOver = 0.564190f / 0.212207f;

/// How far around the touched surfels others can be in the way: a new surfel's distance, and its own reach.
constexpr float margin = fillDistance + fillStray + fillApart;

static float borderScale(surface::Weight weight) {
    return weight == surface::Weight::Gaussian ? gaussianOver : 1.0f;
}

float pinnedAt(surface::Weight weight) {
    return pinnedLimit * borderScale(weight);
}

namespace {

/// Blocks with surfels within `reach` of the selected surfels' boxes, by number, and the box of all of those, and a
/// ball: what a brush touches is round.
struct Surroundings {
    std::vector<std::uint32_t> blocks;
    base::Box3f box;
    float radiusSq = 0; ///< about the box's centre

    bool holds(const base::Vec3f& p) const { return box.contains(p) && distanceSq(p, box.centre()) <= radiusSq; }
};

float farthestSq(const tree::SurfelTree& tree, const tree::Selection& touched, const base::Vec3f& centre) {
    std::vector<float> most(touched.size());
    base::parallelFor(touched.size(), 8, [&](std::size_t i) {
        const surfel::BlockPtr block = tree.block(touched[i].block);
        for (int slot = 0; slot < block->size(); ++slot)
            if (touched[i].slots[static_cast<std::size_t>(slot)])
                most[i] = std::max(most[i], distanceSq(block->position(slot), centre));
    });
    return most.empty() ? 0.0f : *std::max_element(most.begin(), most.end());
}

Surroundings surroundings(const tree::SurfelTree& tree, const tree::Selection& touched, float reach) {
    Surroundings out;
    for (const tree::SelectedBlock& selected : touched) {
        base::CancelScope::check();
        const surfel::BlockPtr block = tree.block(selected.block);
        base::Box3f box;
        for (int slot = 0; slot < block->size(); ++slot)
            if (selected.slots[static_cast<std::size_t>(slot)])
                box.extend(block->position(slot));
        out.box.extend(box);
        tree.forBlocksInBall(box.centre(), 0.5f * box.diagonal() + reach,
                             [&](std::uint32_t number, const surfel::SurfelBlock&) { out.blocks.push_back(number); });
    }
    std::sort(out.blocks.begin(), out.blocks.end());
    out.blocks.erase(std::unique(out.blocks.begin(), out.blocks.end()), out.blocks.end());
    const float radius = std::sqrt(farthestSq(tree, touched, out.box.centre())) + reach;
    out.radiusSq = radius * radius;
    out.box = out.box.inflated(reach);
    return out;
}

/// Those of `touched` whose blocks come within `reach` of others'.
tree::Selection nearTo(const tree::SurfelTree& tree, const tree::Selection& others, const tree::Selection& touched,
                       float reach) {
    const std::vector<std::uint32_t> blocks = surroundings(tree, others, reach).blocks;
    tree::Selection out;
    for (const tree::SelectedBlock& each : touched)
        if (std::binary_search(blocks.begin(), blocks.end(), each.block))
            out.push_back(each);
    return out;
}

/// The slots of a block in a selection, asked for by ascending number.
class Follower {
  public:
    explicit Follower(const tree::Selection& of) : m_at(of.begin()), m_end(of.end()) {}
    std::bitset<surfel::blockCapacity> slots(std::uint32_t block) {
        while (m_at != m_end && m_at->block < block)
            ++m_at;
        return m_at != m_end && m_at->block == block ? m_at->slots : std::bitset<surfel::blockCapacity>();
    }

  private:
    tree::Selection::const_iterator m_at, m_end;
};

} // namespace

SampleSet::SampleSet(const surface::Surface& v, const tree::Selection& touched, const tree::Selection& restless,
                     const ResampleOptions& o, const surface::Surface& f)
    : version(v), frozen(f), options(o), spacing(o.spacing), facing(*v.tree().layout()),
      pinned(o.border > 0 ? o.border : pinnedAt(f.definition().weight)),
      grown(o.border > 0 ? o.border * grownLimit / pinnedLimit : grownLimit * borderScale(f.definition().weight)),
      grownOn(o.goesOn || o.drawnApart ? grownOnLimit * borderScale(f.definition().weight) : grown),
      grid(v.tree().bounds().centre(), fillReach * o.spacing) {
    if (options.support <= 0)
        options.support = supportOf(v.definition(), spacing);
    collect(options.relaxAll ? touched : nearTo(v.tree(), restless, touched, farReach * spacing), restless);
    oldGradient.resize(size());
    refused.resize(size());
    target.resize(size());
    base::parallelFor(size(), 256, [&](std::size_t i) {
        target[i] = options.targetOf ? std::min(spacing, options.targetOf(*block[source[i].block], source[i].slot))
                                     : targetAt(position[i]);
    });
    rebuildGrid();
}

void SampleSet::collect(const tree::Selection& touched, const tree::Selection& restless) {
    const Surroundings around = surroundings(version.tree(), touched, margin * spacing);
    Follower touchedSlots(touched), restlessSlots(restless);
    using Slots = std::bitset<surfel::blockCapacity>;
    blockNumber = around.blocks;
    block.resize(blockNumber.size());
    std::vector<Slots> isTouched(block.size()), isRestless(block.size()), taken(block.size());
    for (std::size_t k = 0; k < block.size(); ++k)
        isTouched[k] = touchedSlots.slots(blockNumber[k]), isRestless[k] = restlessSlots.slots(blockNumber[k]);
    base::parallelFor(block.size(), 8, [&](std::size_t k) {
        block[k] = version.tree().block(blockNumber[k]);
        for (int slot = 0; slot < block[k]->size(); ++slot)
            taken[k].set(static_cast<std::size_t>(slot), around.holds(block[k]->position(slot)));
        taken[k] |= isTouched[k];
    });
    std::vector<std::size_t> first(block.size() + 1, 0);
    for (std::size_t k = 0; k < block.size(); ++k)
        first[k + 1] = first[k] + taken[k].count();
    position.resize(first.back()), normal.resize(first.back());
    flags.resize(first.back()), source.resize(first.back());
    base::parallelFor(block.size(), 8, [&](std::size_t k) {
        std::size_t i = first[k];
        for (std::size_t s = 0; s < surfel::blockCapacity; ++s) {
            if (!taken[k][s])
                continue;
            const int slot = static_cast<int>(s);
            const bool masked = block[k]->mask(slot) >= 1;
            const bool full = options.drawnApart && !options.drawnApart(*block[k], slot);
            const int is = (isTouched[k][s] ? Touched : 0) | (isRestless[k][s] ? Scan : 0) | (masked ? Masked : 0) |
                           (full ? Full : 0);
            position[i] = block[k]->position(slot), normal[i] = block[k]->normal(slot);
            flags[i] = static_cast<std::uint8_t>(is);
            source[i++] = {static_cast<std::uint32_t>(k), static_cast<std::uint8_t>(slot)};
        }
    });
}

/// The mean over those beside which it comes, of its own sheet: the finest would spread otherwise.
float SampleSet::targetBeside(const base::Vec3f& place, std::uint32_t from) const {
    const float radius = fillReach * target[from];
    double sum = double(target[from]);
    int count = 1;
    grid.forNear(place, radius, [&](const PointGrid::Entry& e) {
        if (e.index != from && distanceSq(e.position, place) < radius * radius &&
            facing.same(normal[from], normal[e.index]))
            sum += double(target[e.index]), ++count;
    });
    return static_cast<float>(sum / count);
}

std::uint32_t SampleSet::bear(const base::Vec3f& place, const base::Vec3f& direction, std::uint32_t from) {
    const auto index = static_cast<std::uint32_t>(size());
    position.push_back(place);
    normal.push_back(direction);
    flags.push_back(Touched | New | Moved);
    refused.push_back(0);
    target.push_back(options.targetOf ? targetBeside(place, from) : targetAt(place));
    grid.insert({place, index});
    return index;
}

void SampleSet::rebuildGrid() {
    std::vector<PointGrid::Entry> entries;
    entries.reserve(size());
    for (std::uint32_t i = 0; i < size(); ++i)
        if (!is(i, Gone))
            entries.push_back({position[i], i});
    grid.build(entries);
}

void SampleSet::scanAround(std::size_t i, float radius) {
    grid.forNear(position[i], radius, [&](const PointGrid::Entry& e) {
        if (is(e.index, Touched) && !is(e.index, Gone) && distanceSq(e.position, position[i]) < radius * radius)
            mark(e.index, Scan);
    });
}

void SampleSet::scanNearMoved(float reach) {
    const float spread = options.targetOf ? unlike
                         : options.field  ? 1 + grading * reach
                                          : 1.0f; // targets may be larger there
    std::vector<std::uint8_t> near(size());
    base::parallelFor(size(), 128, [&](std::size_t i) {
        if (!is(i, Touched) || is(i, Gone))
            return;
        bool found = is(i, Moved);
        if (!found)
            grid.forNear(position[i], reach * spread * target[i], [&](const PointGrid::Entry& e) {
                const float radius = reach * target[e.index];
                found |= is(e.index, Moved) && distanceSq(e.position, position[i]) < radius * radius;
            });
        near[i] = found ? 1 : 0;
    });
    for (std::size_t i = 0; i < size(); ++i)
        if (near[i])
            mark(i, Scan);
}

} // namespace process
