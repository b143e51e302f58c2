#include "core/sculpt/tools/layer.h"

#include "core/base/parallel.h"
#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather.h"
#include "core/surface/projection/project.h"

#include <algorithm>
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
    base::Vec3f foot, normal; ///< on the version that the stroke began on; its unit gradient
    base::Mat3f bend;         ///< the gradient of the model's normal there, turned as `normal` is
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

    std::vector<Footing>& around(const surfel::BlockPtr& block) {
        Known& known = blocks[block.get()];
        if (!known.block)
            known = {block, std::vector<Footing>(static_cast<std::size_t>(block->size()))};
        return known.of;
    }
};

std::vector<surface::Projection<float>> feetOf(const surface::Surface& first, std::span<const base::Vec3f> places) {
    surface::ProjectOptions options;
    options.tolerance = 1e-5;
    options.checkBoundary = false;
    std::vector<surface::Projection<float>> out(places.size());
    surface::project(first, places, options, out);
    return out;
}

PastDab onFirst(const surface::Surface& first, PastDab dab) {
    const auto foot = feetOf(first, {&dab.centre, 1});
    dab.centre = foot[0].ok() ? foot[0].foot : dab.centre;
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

Footing footingOf(const surface::Projection<float>& foot) {
    Footing out;
    out.normal = normalized(foot.at.gradient);
    out.state = foot.ok() && out.normal != base::Vec3f{} ? Footing::State::Found : Footing::State::None;
    if (out.state == Footing::State::None)
        return out;
    out.foot = foot.foot;
    const base::Mat3f flat = base::Mat3f::identity() - outer(out.normal, out.normal);
    out.bend =
        flat * (dot(foot.at.normal, out.normal) < 0 ? foot.at.normalGradient * -1.0f : foot.at.normalGradient) * flat;
    return out;
}

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
        find(first, list);
        base::parallelFor(m_footings.size(), 64, [&](std::size_t i) { bringUpToDate(*m_footings[i]); });
    }

    /// D of a surfel and its gradient; false where it has no foot.
    bool shiftOf(std::size_t i, const base::Vec3f& p, const base::Vec3f& outwards, float height, base::Vec3f& shift,
                 base::Mat3f& gradient) const {
        const Footing& of = *m_footings[i];
        if (of.state != Footing::State::Found)
            return false;
        const float side = dot(of.normal, outwards) < 0 ? -1.0f : 1.0f;
        const base::Vec3f n = of.normal * side;
        const base::Mat3f bend = of.bend * side;
        const base::Mat3f flat = base::Mat3f::identity() - outer(n, n);
        const base::Mat3f toFoot = inverse(base::Mat3f::identity() + bend * dot(n, p - of.foot)) * flat;
        // P_k - P_{k-1} at the foot, and its gradient.
        Left now;
        multiply(m_brush, m_now, of.foot, now);
        const float step = of.left.value * (1 - now.value);
        const base::Vec3f slope = of.left.slope * (1 - now.value) - now.slope * of.left.value;
        shift = n * (height * step);
        gradient = outer(n, transposed(toFoot) * (slope * height)) + bend * toFoot * (height * step);
        return true;
    }

  private:
    void find(const surface::Surface& first, const Gathered& list) {
        std::vector<std::size_t> fresh;
        std::vector<base::Vec3f> places;
        for (std::size_t i = 0; i < m_footings.size(); ++i)
            if (m_footings[i]->state == Footing::State::Unknown)
                fresh.push_back(i), places.push_back(list.places[i]);
        const auto feet = feetOf(first, places);
        for (std::size_t k = 0; k < fresh.size(); ++k)
            *m_footings[fresh[k]] = footingOf(feet[k]);
    }
    void bringUpToDate(Footing& of) const {
        for (; of.dabs < m_memory.past.size(); ++of.dabs)
            if (of.state == Footing::State::Found)
                multiply(m_brush, m_memory.past[of.dabs], of.foot, of.left);
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
