#include "core/sculpt/tools/layer.h"

#include "core/base/parallel.h"
#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather.h"
#include "core/sculpt/tools/layer_feet.h"
#include "core/tree/nearest_together.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace sculpt {

constexpr ToolParameter parameters[] = {
    {"height", "Height", "radii", "Greatest thickness of the layer that one stroke lays.", 0.1, 0.005, 0.5},
};

namespace {

/// 1 - P over the dabs so far, and its gradient.
struct Left {
    float value = 1;
    base::Vec3f slope;
};

/// What the stroke has found out about a surfel. Moved along its normal, it keeps its foot.
struct Footing {
    enum class State : std::uint8_t { Unknown, Found, None } state = State::Unknown;
    LayerFoot on; ///< the version that the stroke began on
    Left left;
    std::size_t dabs = 0; ///< of the past that `left` knows
};

/// Of all surfels that have been under the brush.
struct Memory : ToolMemory {
    struct Known {
        surfel::BlockPtr block; ///< held, so that no other has its address
        std::vector<Footing> of;
    };
    std::unordered_map<const surfel::SurfelBlock*, Known> blocks;
    std::vector<PastDab> past; ///< with centres on the first version
    tree::SurfelTree last;     ///< that the last dab left, all of whose surfels under the brush are known

    std::vector<Footing>& around(const surfel::BlockPtr& block) {
        Known& known = blocks[block.get()];
        if (!known.block)
            known = {block, std::vector<Footing>(static_cast<std::size_t>(block->size()))};
        return known.of;
    }
};

PastDab onFirst(const surface::Surface& first, PastDab dab) {
    dab.centre = layerFoot(first, dab.centre).value_or(dab.centre);
    dab.strength = std::min(1.0f, std::abs(dab.strength));
    return dab;
}

/// What a dab leaves of 1 - P at q.
void multiply(const Brush& brush, const PastDab& dab, const base::Vec3f& q, Left& out) {
    const base::Vec3f d = q - dab.centre;
    const float l = length(d), r = l / dab.radius;
    if (r >= 1)
        return;
    float w = 0, slope = 0;
    weights(brush.falloff, 0, {&r, 1}, {&w, 1}, {&slope, 1}, brush.curve.get());
    const float factor = 1 - dab.strength * w;
    const float k = l > 1e-12f ? -dab.strength * slope / (dab.radius * l) : 0.0f; // grad factor = k d
    out.slope = out.slope * factor + d * (k * out.value);
    out.value *= factor;
}

/// How many of the nearest are asked whether they are known.
constexpr std::size_t asked = 8;
/// Normals of one sheet.
constexpr float alike = 0.17f;

/// What a stroke knows of surfels that stand in other blocks by now, or that its resampling has moved or made: the same
/// place has the same foot, another the foot of its nearest neighbour, as far beside it as the two are apart. What lies
/// where it lay at the beginning is looked for there.
class Remembering {
  public:
    Remembering(const Memory& memory, const tree::SurfelTree& began)
        : m_memory(memory), m_layout(*began.layout()), m_around(memory.last, asked), m_began(began, 1) {}

    struct Wanted {
        base::Vec3f place, normal;
        Footing* footing;
        base::Vec3f start; ///< where its foot is looked for
    };
    /// At most 16.
    void recall(std::span<Wanted> some) {
        std::array<base::Vec3f, surfel::clusterSize> places;
        for (std::size_t i = 0; i < some.size(); ++i)
            places[i] = some[i].place;
        m_around.at(std::span(places).first(some.size()));
        m_began.at(std::span(places).first(some.size()));
        for (std::size_t i = 0; i < some.size(); ++i)
            if (const auto before = m_began.of(i); before.empty() || before[0].distanceSq > 0)
                recallOne(some[i], m_around.of(i));
    }

  private:
    void recallOne(Wanted& each, std::span<const tree::Neighbour> near) const {
        for (const tree::Neighbour& other : near) {
            const auto known = m_memory.blocks.find(other.block);
            if (known == m_memory.blocks.end())
                continue;
            const Footing& its = known->second.of[static_cast<std::size_t>(other.slot)];
            if (its.state != Footing::State::Found || !sameSheet(each.normal, other.block->normal(other.slot)))
                continue;
            if (other.distanceSq == 0)
                *each.footing = its;
            else
                each.start = each.place - (other.block->position(other.slot) - its.on.foot);
            return;
        }
    }
    bool sameSheet(const base::Vec3f& a, const base::Vec3f& b) const {
        const float c = dot(a, b);
        return !m_layout.normals || (m_layout.oriented ? c : std::abs(c)) > alike;
    }

    const Memory& m_memory;
    const surfel::AttributeLayout& m_layout;
    tree::NearestTogether m_around, m_began;
};

/// The dab, with what is known of each surfel in the list brought up to date.
class Layering {
  public:
    Layering(const surface::Surface& version, const Dab& dab, const std::vector<BrushBlock>& blocks,
             const Gathered& list, Memory& memory)
        : m_brush(dab), m_memory(memory), m_footings(list.places.size()) {
        const surface::Surface& first = dab.first ? *dab.first : version;
        for (std::size_t k = memory.past.size(); k < dab.past.size(); ++k)
            memory.past.push_back(onFirst(first, dab.past[k]));
        m_now = onFirst(first, {dab.centre, dab.radius, dab.strength});
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            if (list.first[b] == list.first[b + 1])
                continue;
            std::vector<Footing>& of = memory.around(version.tree().block(blocks[b].number));
            for (std::size_t i = list.first[b]; i < list.first[b + 1]; ++i)
                m_footings[i] = &of[static_cast<std::size_t>(list.slots[i])];
        }
        find(first, blocks, list);
        base::parallelFor(m_footings.size(), 64, [&](std::size_t i) { bringUpToDate(*m_footings[i]); });
    }

    /// D of a surfel and its gradient; false where it has no foot.
    bool shiftOf(std::size_t i, const base::Vec3f& p, const base::Vec3f& outwards, float height, base::Vec3f& shift,
                 base::Mat3f& gradient) const {
        const Footing& of = *m_footings[i];
        if (of.state != Footing::State::Found)
            return false;
        const float side = dot(of.on.normal, outwards) < 0 ? -1.0f : 1.0f;
        const base::Vec3f n = of.on.normal * side;
        const base::Mat3f bend = of.on.bend * side;
        const base::Mat3f flat = base::Mat3f::identity() - outer(n, n);
        const base::Mat3f toFoot = inverse(base::Mat3f::identity() + bend * dot(n, p - of.on.foot)) * flat;
        // P_k - P_{k-1} at the foot, and its gradient.
        Left now;
        multiply(m_brush, m_now, of.on.foot, now);
        const float step = of.left.value * (1 - now.value);
        const base::Vec3f slope = of.left.slope * (1 - now.value) - now.slope * of.left.value;
        shift = n * (height * step);
        gradient = outer(n, transposed(toFoot) * (slope * height)) + bend * toFoot * (height * step);
        return true;
    }

  private:
    using Wanted = Remembering::Wanted;

    void find(const surface::Surface& first, const std::vector<BrushBlock>& blocks, const Gathered& list) {
        const tree::SurfelTree& began = first.tree();
        std::vector<Wanted> moved, there;
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            const surfel::SurfelBlock& block = *blocks[b].block;
            const std::uint32_t number = blocks[b].number;
            const bool asItWas = number < began.blockCount() && began.block(number).get() == &block;
            for (std::size_t i = list.first[b]; i < list.first[b + 1]; ++i)
                if (m_footings[i]->state == Footing::State::Unknown)
                    (asItWas ? there : moved)
                        .push_back({list.places[i], block.normal(list.slots[i]), m_footings[i], list.places[i]});
        }
        remember(began, moved);
        for (const Wanted& each : moved)
            if (each.footing->state == Footing::State::Unknown)
                there.push_back(each);
        measure(first, there);
    }
    void remember(const tree::SurfelTree& began, std::vector<Wanted>& moved) const {
        if (m_memory.last.empty())
            return;
        base::parallelChunks(
            moved.size(), 16 * surfel::clusterSize, [&](std::size_t begin, std::size_t end, std::size_t) {
                Remembering memory(m_memory, began);
                for (std::size_t i = begin; i < end; i += surfel::clusterSize)
                    memory.recall(std::span(moved).subspan(i, std::min<std::size_t>(surfel::clusterSize, end - i)));
            });
    }
    static void measure(const surface::Surface& first, const std::vector<Wanted>& wanted) {
        std::vector<base::Vec3f> starts, places;
        for (const Wanted& each : wanted)
            starts.push_back(each.start), places.push_back(each.place);
        const auto feet = layerFeet(first, starts, places);
        for (std::size_t k = 0; k < feet.size(); ++k) {
            wanted[k].footing->state = feet[k] ? Footing::State::Found : Footing::State::None;
            wanted[k].footing->on = feet[k].value_or(LayerFoot{});
        }
    }
    void bringUpToDate(Footing& of) const {
        for (; of.dabs < m_memory.past.size(); ++of.dabs)
            if (of.state == Footing::State::Found)
                multiply(m_brush, m_memory.past[of.dabs], of.on.foot, of.left);
    }

    const Brush m_brush;
    const Memory& m_memory;
    PastDab m_now;
    std::vector<Footing*> m_footings; ///< of the list
};

/// Surfels that have moved are known in their new blocks.
void follow(Memory& memory, const tree::SurfelTree& tree, const tree::Edit& edit) {
    for (const tree::BlockEdit& each : edit.blocks) {
        const auto known = memory.blocks.find(tree.block(each.block).get());
        if (!each.changed || known == memory.blocks.end())
            continue;
        Memory::Known moved{each.changed, std::move(known->second.of)};
        memory.blocks.erase(known);
        memory.blocks.insert_or_assign(each.changed.get(), std::move(moved));
    }
    memory.last = tree.apply(edit);
}

} // namespace

static tree::Edit layer(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    if (dab.strength == 0)
        return {};
    std::unique_ptr<ToolMemory> once;
    Memory& memory = memoryOf<Memory>(dab, once);
    const float height = std::copysign(dab.parameter("height") * dab.radius, dab.strength);
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    const Gathered list = gather(blocks, brush);
    const Layering layering(version, dab, blocks, list, memory);
    const auto field = [&](const LanePlace& where, const BrushLanes&, ShiftLanes& out) {
        out.clear();
        list.forCluster(where.index, where.cluster, [&](std::size_t i, std::size_t lane) {
            const base::Vec3f outwards = dab.oriented ? where.in.block->normal(list.slots[i]) : dab.areaNormal;
            base::Vec3f shift;
            base::Mat3f gradient;
            if (layering.shiftOf(i, list.places[i], outwards, height, shift, gradient))
                out.set(lane, shift, gradient);
        });
    };
    tree::Edit edit = deform(version.tree(), blocks, brush, field);
    const bool onFirst = dab.first && version.tree() == dab.first->tree(); // where dabs do not add up, always
    if (dab.memory && !onFirst)
        follow(memory, version.tree(), edit);
    return edit;
}

const ToolRow layerTool{"layer",
                        "Layer",
                        "icons/tool-layer.svg",
                        "L",
                        "Raises the surface by a limited height, however often the stroke passes; inverted, lowers it.",
                        Motion::Along,
                        0.5,
                        parameters,
                        layer,
                        Writes::Surface};

} // namespace sculpt
