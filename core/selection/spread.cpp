// Sources are taken in falling order of their values. Those of one value send a front along the links (Dijkstra); it
// stops where a front came nearer before, which had a value at least as high, so that the first to arrive is the
// highest.
#include "core/selection/spread.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/selection/links.h"

#include <algorithm>
#include <memory>
#include <queue>

namespace selection {

using surfel::SurfelBlock;

namespace {

struct Source {
    float value;
    std::uint32_t block;
    int slot;
    bool operator<(const Source& o) const {
        return value != o.value ? value > o.value : block != o.block ? block < o.block : slot < o.slot;
    }
};

struct Front {
    float distance;
    std::uint32_t block;
    int slot;
    bool operator<(const Front& o) const { // nearest first out of a queue
        return distance != o.distance ? distance > o.distance : block != o.block ? block > o.block : slot > o.slot;
    }
};

/// What is known of the surfels of one block that a front has met.
struct Met {
    BlockValues distance, value;
};

class Spread {
  public:
    Spread(const surface::Surface& surface, Field field, bool inverse)
        : m_surface(surface), m_links(surface), m_field(field), m_inverse(inverse),
          m_channel(channelOf(*surface.tree().layout(), field)), m_blocks(blocksOf(surface.tree())),
          m_met(m_blocks.size()) {}

    float own(const SurfelBlock& block, int slot) const {
        const float v = valueAt(block, m_channel, slot);
        return m_inverse ? 1 - v : v;
    }

    /// Surfels with a value that are linked with a lower one, in no order.
    std::vector<Source> sources() const {
        std::vector<float> least(m_blocks.size(), 2), most(m_blocks.size(), -1);
        base::parallelFor(m_blocks.size(), 64, [&](std::size_t b) {
            for (int slot = 0; slot < m_blocks[b]->size(); ++slot) {
                const float v = own(*m_blocks[b], slot);
                least[b] = std::min(least[b], v), most[b] = std::max(most[b], v);
            }
        });
        std::vector<std::vector<Source>> found(m_blocks.size());
        base::parallelFor(m_blocks.size(), 8, [&](std::size_t b) {
            const SurfelBlock& block = *m_blocks[b];
            bool varies = false;
            if (most[b] > 0)
                m_surface.tree().forBlocksInSupport(
                    block.box().inflated(m_links.lengthAt(block.maxSupport())),
                    [&](std::uint32_t other, const SurfelBlock&) { varies |= least[other] < most[b]; },
                    m_links.reach());
            for (int slot = 0; varies && slot < block.size(); ++slot) {
                const float v = own(block, slot);
                bool higher = false;
                if (v > 0)
                    m_links.forEach(block, slot, [&](std::uint32_t, const SurfelBlock& other, int k, float) {
                        higher |= own(other, k) < v;
                    });
                if (higher)
                    found[b].push_back({v, static_cast<std::uint32_t>(b), slot});
            }
        });
        std::vector<Source> out;
        for (const std::vector<Source>& each : found)
            out.insert(out.end(), each.begin(), each.end());
        return out;
    }

    tree::SurfelTree run(float length, const base::Progress& progress) {
        if (m_channel < 0)
            return m_surface.tree();
        std::vector<Source> all = sources();
        std::sort(all.begin(), all.end());
        for (std::size_t begin = 0, end; begin < all.size(); begin = end) {
            progress.step(static_cast<double>(begin) / static_cast<double>(all.size()), "Spreading");
            for (end = begin; end < all.size() && all[end].value == all[begin].value; ++end)
                if (Met& met = metAt(all[end].block); true) {
                    met.distance[static_cast<std::size_t>(all[end].slot)] = 0;
                    m_queue.push({0, all[end].block, all[end].slot});
                }
            advance(all[begin].value, length);
        }
        return written();
    }

  private:
    Met& metAt(std::uint32_t block) {
        if (!m_met[block]) {
            m_met[block] = std::make_unique<Met>();
            m_met[block]->distance.fill(std::numeric_limits<float>::infinity());
            m_met[block]->value.fill(-1);
        }
        return *m_met[block];
    }

    void advance(float value, float length) {
        for (int count = 0; !m_queue.empty(); ++count) {
            if (count % 1024 == 0)
                base::CancelScope::check();
            const Front at = m_queue.top();
            m_queue.pop();
            if (at.distance > metAt(at.block).distance[static_cast<std::size_t>(at.slot)])
                continue;
            m_links.forEach(*m_blocks[at.block], at.slot,
                            [&](std::uint32_t number, const SurfelBlock& other, int k, float d) {
                                const auto slot = static_cast<std::size_t>(k);
                                const float distance = at.distance + d;
                                if (!(distance <= length) || own(other, k) >= value)
                                    return;
                                Met& met = metAt(number);
                                if (!(distance < met.distance[slot]))
                                    return;
                                met.distance[slot] = distance;
                                met.value[slot] = std::max(met.value[slot], value);
                                m_queue.push({distance, number, k});
                            });
        }
    }

    tree::SurfelTree written() const {
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t b = 0; b < m_met.size(); ++b)
            if (m_met[b])
                numbers.push_back(b);
        return rewritten(m_surface.tree(), m_field, numbers,
                         [&](std::uint32_t number, const SurfelBlock& block, BlockValues& values) {
                             for (std::size_t i = 0; i < static_cast<std::size_t>(block.size()); ++i)
                                 if (const float v = m_met[number]->value[i]; v >= 0)
                                     values[i] = m_inverse ? 1 - v : v;
                         });
    }

    const surface::Surface& m_surface;
    Links m_links;
    Field m_field;
    bool m_inverse;
    int m_channel;
    std::vector<const SurfelBlock*> m_blocks;
    std::vector<std::unique_ptr<Met>> m_met;
    std::priority_queue<Front> m_queue;
};

} // namespace

tree::SurfelTree grown(const surface::Surface& surface, Field field, double length, const base::Progress& progress) {
    return Spread(surface, field, false).run(static_cast<float>(length), progress);
}

tree::SurfelTree shrunk(const surface::Surface& surface, Field field, double length, const base::Progress& progress) {
    return Spread(surface, field, true).run(static_cast<float>(length), progress);
}

tree::Selection borderOf(const surface::Surface& surface, Field field) {
    tree::Selection out = selectedIn(surface.tree(), field);
    const int channel = channelOf(*surface.tree().layout(), field);
    const Links links(surface);
    const std::vector<const SurfelBlock*> blocks = blocksOf(surface.tree());
    base::parallelFor(out.size(), 8, [&](std::size_t b) {
        const SurfelBlock& block = *blocks[out[b].block];
        for (int slot = 0; slot < block.size(); ++slot) {
            bool beside = false;
            if (out[b].slots[static_cast<std::size_t>(slot)])
                links.forEach(block, slot, [&](std::uint32_t, const SurfelBlock& other, int k, float) {
                    beside |= valueAt(other, channel, k) < half;
                });
            out[b].slots[static_cast<std::size_t>(slot)] = beside;
        }
    });
    std::erase_if(out, [](const tree::SelectedBlock& block) { return block.slots.none(); });
    return out;
}

} // namespace selection
