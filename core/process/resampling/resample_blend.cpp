#include "core/process/resampling/resample_blend.h"

#include "core/base/parallel.h"
#include "core/process/resampling/resample_land.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"
#include "core/surface/rims.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace process {

constexpr std::size_t grain = 32;
/// In spacings: how far around a place blocks are collected for those that follow.
constexpr float slack = 3;

Blender::Blender(const surface::Surface& frozen, float spacing, std::span<const base::Vec3f> places)
    : m_frozen(frozen), m_layout(*frozen.tree().layout()), m_facing(m_layout),
      m_rims(surface::knowsRims(frozen) ? surface::rimChannel(m_layout) : std::nullopt), m_limit(heightLimit * spacing),
      m_slack(slack * spacing) {
    collectBlocks(places);
    m_needed = std::vector<std::atomic<std::uint8_t>>(m_blocks.size() * surfel::blockCapacity);
    m_measured.resize(m_needed.size());
    base::parallelChunks(places.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        Near near;
        for (std::size_t i = begin; i < end; ++i)
            markNeeded(places[i], near);
    });
    measure();
}

void Blender::collectBlocks(std::span<const base::Vec3f> places) {
    std::vector<std::vector<const surfel::SurfelBlock*>> parts(base::chunkCount(places.size(), grain));
    base::parallelChunks(places.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        base::Box3f done;
        for (std::size_t i = begin; i < end; ++i) {
            if (done.contains(places[i]))
                continue;
            done = base::Box3f{places[i], places[i]}.inflated(m_slack);
            m_frozen.tree().forBlocksInSupport(
                done, [&](std::uint32_t, const surfel::SurfelBlock& block) { parts[chunk].push_back(&block); });
        }
        std::sort(parts[chunk].begin(), parts[chunk].end());
        parts[chunk].erase(std::unique(parts[chunk].begin(), parts[chunk].end()), parts[chunk].end());
    });
    for (const auto& part : parts)
        m_blocks.insert(m_blocks.end(), part.begin(), part.end());
    std::sort(m_blocks.begin(), m_blocks.end());
    m_blocks.erase(std::unique(m_blocks.begin(), m_blocks.end()), m_blocks.end());
}

void Blender::lookAround(const base::Vec3f& x, Near& near) const {
    if (near.box.contains(x))
        return;
    near.box = base::Box3f{x, x}.inflated(m_slack);
    near.blocks.clear();
    m_frozen.tree().forBlocksInSupport(near.box, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        const auto at = std::lower_bound(m_blocks.begin(), m_blocks.end(), &block);
        if (at != m_blocks.end() && *at == &block)
            near.blocks.push_back({&block, static_cast<std::size_t>(at - m_blocks.begin())});
    });
}

template <class Fn>
void Blender::forWeights(const base::Vec3f& x, Near& near, const Fn& fn) const {
    const surface::Weight kind = m_frozen.definition().weight;
    const int shape = surfel::shapeChannel(*m_frozen.tree().layout());
    lookAround(x, near);
    for (const auto& [block, which] : near.blocks)
        for (unsigned left = block->boundsLanes().supporting(x); left != 0; left &= left - 1) {
            surface::forWeights(
                *block, std::countr_zero(left), kind, x,
                [&, &of = *block, first = which * surfel::blockCapacity](int slot, float w) {
                    fn(of, slot, first + static_cast<std::size_t>(slot), w);
                },
                shape);
        }
}

void Blender::markNeeded(const base::Vec3f& x, Near& near) {
    lookAround(x, near);
    float distanceSq[surfel::clusterSize];
    for (const auto& [block, which] : near.blocks)
        for (unsigned left = block->boundsLanes().supporting(x); left != 0; left &= left - 1) {
            const int cluster = std::countr_zero(left);
            std::atomic<std::uint8_t>* needed = m_needed.data() + which * surfel::blockCapacity +
                                                static_cast<std::size_t>(cluster * surfel::clusterSize);
            for (unsigned in = surface::withinSupport(*block, cluster, x, distanceSq); in != 0; in &= in - 1)
                needed[std::countr_zero(in)].store(1, std::memory_order_relaxed);
        }
}

Blender::Measured Blender::measured(const surface::TogetherAt& e, const base::Vec3f& n) const {
    const float slope = length(e.gradient);
    Measured out;
    if (!(e.ok() || e.status == surface::Status::BeyondBoundary) || !(slope > 0.05f))
        return out;
    out.gradient = e.gradient / slope;
    const bool turned = dot(n, out.gradient) < 0;
    out.height = std::clamp(centredValue(m_frozen, e) / slope, -m_limit, m_limit);
    out.tilt = (turned ? -n : n) - out.gradient;
    return out;
}

void Blender::measure() {
    std::vector<std::uint32_t> needed;
    for (std::uint32_t index = 0; index < m_needed.size(); ++index)
        if (m_needed[index].load(std::memory_order_relaxed))
            needed.push_back(index);
    const auto slotOf = [](std::uint32_t index) { return static_cast<int>(index % surfel::blockCapacity); };
    std::vector<base::Vec3f> places(needed.size()), sides(needed.size());
    for (std::size_t k = 0; k < needed.size(); ++k) {
        const surfel::SurfelBlock& block = *m_blocks[needed[k] / surfel::blockCapacity];
        places[k] = block.position(slotOf(needed[k])), sides[k] = block.normal(slotOf(needed[k]));
    }
    std::vector<surface::TogetherAt> at(needed.size());
    surface::evaluateTogether(m_frozen, places, sides, at);
    base::parallelFor(needed.size(), 256, [&](std::size_t k) { m_measured[needed[k]] = measured(at[k], sides[k]); });
}

void Blender::at(const base::Vec3f& x, const base::Vec3f& gradient, Near& near, Blend& out) const {
    surface::AttributeSum facing(m_layout), others(m_layout);
    double weight = 0, height = 0, support = 0;
    base::Vec3d tilt;
    double ofRims = 0;
    const int shape = surfel::shapeChannel(m_layout);
    forWeights(x, near, [&](const surfel::SurfelBlock& block, int slot, std::size_t index, float w) {
        const base::Vec3f n = block.normal(slot);
        if (m_facing.oriented() && dot(n, gradient) <= -0.17f)
            return others.add(block, slot, w);
        facing.add(block, slot, w);
        ofRims += m_rims && surface::tellsOfRim(block, slot, *m_rims) ? double(w) : 0;
        weight += double(w);
        support += double(w) * double(surfel::ballOf(block, slot, shape));
        const Measured& m = m_measured[index];
        const double side = dot(m.gradient, gradient) < 0 ? -double(w) : double(w);
        height += side * double(m.height);
        tilt += base::cast<double>(m.tilt) * side;
    });
    out = {};
    out.words.assign(m_layout.words(), 0);
    if (facing.any()) {
        out.height = static_cast<float>(height / weight);
        out.ofRims = static_cast<float>(ofRims / weight);
        out.tilt = base::cast<float>(tilt / weight);
        out.support = static_cast<float>(support / weight);
    }
    const surface::AttributeSum& sum = facing.any() ? facing : others;
    if (!sum.any())
        return;
    out.colour = sum.colour();
    out.mask = sum.mask();
    sum.further(out.words);
}

} // namespace process
