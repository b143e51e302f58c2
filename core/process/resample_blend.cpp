#include "core/process/resample_blend.h"

#include "core/base/parallel.h"
#include "core/process/resample_land.h"

#include <algorithm>
#include <cmath>

namespace process {

/// alg. 2.1
static float weightAt(surface::Weight kind, float distanceSq, float support) {
    if (!(distanceSq < support * support))
        return 0;
    if (kind == surface::Weight::Gaussian) {
        const float unit = surface::unitOf(kind, support);
        return std::exp(-distanceSq / (unit * unit));
    }
    const float r = std::sqrt(distanceSq) / support, t = (1 - r) * (1 - r);
    return t * t * (4 * r + 1);
}

constexpr std::size_t grain = 32;

Blender::Blender(const surface::Surface& frozen, float spacing, std::span<const base::Vec3f> places)
    : m_frozen(frozen), m_layout(*frozen.tree().layout()), m_facing(m_layout), m_limit(heightLimit * spacing) {
    collectBlocks(places);
    m_needed = std::vector<std::atomic<std::uint8_t>>(m_blocks.size() * surfel::blockCapacity);
    m_measured.resize(m_needed.size());
    base::parallelFor(places.size(), grain, [&](std::size_t i) { markNeeded(places[i]); });
    measure();
}

void Blender::collectBlocks(std::span<const base::Vec3f> places) {
    std::vector<std::vector<const surfel::SurfelBlock*>> parts(base::chunkCount(places.size(), grain));
    base::parallelChunks(places.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        auto& part = parts[chunk];
        for (std::size_t i = begin; i < end; ++i)
            m_frozen.tree().forClustersInSupport(places[i], [&](const surfel::SurfelBlock& block, int) {
                if (part.empty() || part.back() != &block)
                    part.push_back(&block);
            });
        std::sort(part.begin(), part.end());
        part.erase(std::unique(part.begin(), part.end()), part.end());
    });
    for (const auto& part : parts)
        m_blocks.insert(m_blocks.end(), part.begin(), part.end());
    std::sort(m_blocks.begin(), m_blocks.end());
    m_blocks.erase(std::unique(m_blocks.begin(), m_blocks.end()), m_blocks.end());
}

std::size_t Blender::placeOf(const surfel::SurfelBlock* block) const {
    return static_cast<std::size_t>(std::lower_bound(m_blocks.begin(), m_blocks.end(), block) - m_blocks.begin());
}

template <class Fn>
void Blender::forWeights(const base::Vec3f& x, const Fn& fn) const {
    const surface::Weight kind = m_frozen.definition().weight;
    m_frozen.tree().forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const std::size_t first = placeOf(&block) * surfel::blockCapacity;
        const int end = std::min(block.size(), (cluster + 1) * surfel::clusterSize);
        for (int slot = cluster * surfel::clusterSize; slot < end; ++slot)
            if (const float w = weightAt(kind, distanceSq(block.position(slot), x), block.support(slot)); w > 0)
                fn(block, slot, first + static_cast<std::size_t>(slot), w);
    });
}

void Blender::markNeeded(const base::Vec3f& x) {
    forWeights(x, [&](const surfel::SurfelBlock&, int, std::size_t index, float) {
        m_needed[index].store(1, std::memory_order_relaxed);
    });
}

Blender::Measured Blender::measured(const base::Vec3f& p, const base::Vec3f& n) const {
    const surface::Evaluationf e = m_frozen.evaluate(p, surface::Need::Gradient, {n});
    const float slope = length(e.gradient);
    Measured out;
    if (!(e.ok() || e.status == surface::Status::BeyondBoundary) || !(slope > 0.05f))
        return out;
    out.gradient = e.gradient / slope;
    const bool turned = dot(n, out.gradient) < 0;
    out.height = std::clamp(centredValue(m_frozen, p, e) / slope, -m_limit, m_limit);
    out.tilt = (turned ? -n : n) - out.gradient;
    return out;
}

void Blender::measure() {
    base::parallelFor(m_blocks.size(), 4, [&](std::size_t b) {
        for (int slot = 0; slot < m_blocks[b]->size(); ++slot) {
            const std::size_t index = b * surfel::blockCapacity + static_cast<std::size_t>(slot);
            if (m_needed[index].load(std::memory_order_relaxed))
                m_measured[index] = measured(m_blocks[b]->position(slot), m_blocks[b]->normal(slot));
        }
    });
}

namespace {

/// Sums of what a surfel carries beside its place.
struct Carried {
    const surfel::AttributeLayout& layout;
    double weight = 0, mask = 0, channel[4] = {};
    float largest = 0;
    std::vector<double> reals;
    std::vector<std::uint32_t> words, nearest;

    explicit Carried(const surfel::AttributeLayout& l)
        : layout(l), reals(l.attributes().size(), 0.0), words(l.words()), nearest(l.words()) {}

    void add(const surfel::SurfelBlock& block, int slot, float w) {
        const surfel::Surfel s = block.surfel(slot);
        weight += w;
        mask += double(w) * double(s.mask);
        for (int c = 0; c < 4; ++c)
            channel[c] += double(w) * double(s.colour >> (8 * c) & 255u);
        if (words.empty())
            return;
        block.extra(slot, words);
        for (std::size_t a = 0; a < reals.size(); ++a)
            reals[a] += double(w) * surfel::read(layout.attributes()[a], words);
        if (w > largest)
            largest = w, nearest = words;
    }

    void write(Blend& out) const {
        out.mask = static_cast<float>(mask / weight);
        out.colour = 0;
        for (int c = 0; c < 4; ++c)
            out.colour |= static_cast<std::uint32_t>(std::lround(channel[c] / weight)) << (8 * c);
        out.words = nearest;
        for (std::size_t a = 0; a < reals.size(); ++a)
            if (surfel::isReal(layout.attributes()[a].type))
                surfel::write(layout.attributes()[a], out.words, reals[a] / weight);
    }
};

} // namespace

void Blender::at(const base::Vec3f& x, const base::Vec3f& gradient, Blend& out) const {
    Carried facing(m_layout), all(m_layout);
    double height = 0;
    base::Vec3d tilt;
    forWeights(x, [&](const surfel::SurfelBlock& block, int slot, std::size_t index, float w) {
        const base::Vec3f n = block.normal(slot);
        if (m_facing.oriented() && dot(n, gradient) <= -0.17f)
            return all.add(block, slot, w);
        facing.add(block, slot, w);
        const Measured& m = m_measured[index];
        const double side = dot(m.gradient, gradient) < 0 ? -double(w) : double(w);
        height += side * double(m.height);
        tilt += base::cast<double>(m.tilt) * side;
    });
    out = {};
    if (facing.weight > 0) {
        out.height = static_cast<float>(height / facing.weight);
        out.tilt = base::cast<float>(tilt / facing.weight);
        facing.write(out);
    } else if (all.weight > 0) {
        all.write(out);
    } else {
        out.words.assign(m_layout.words(), 0);
    }
}

} // namespace process
