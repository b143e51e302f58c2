// To which supports a dab of density (density.h) brings the surfels under it, and what its stroke has found of those.
// Internal to the tool. Lengths in model units; const functions may run on any thread.
#pragma once

#include "core/base/parallel.h"
#include "core/process/estimation/chance.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/block_memo.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sculpt {

/// How fast supports may change over distance (sculpt/README 6.4).
constexpr float grading = 0.5f;
/// Where the stroke found a sampling that differs by more than this from the centre's, a dab does less and less, up to
/// where it does nothing: searches reach as far as the coarsest asks, and there the stroke has not come yet.
constexpr float alikeSampling = 1.6f, unlikeSampling = 2.5f;
/// So near to what a stroke is to leave, in parts of it, a surfel has its support.
constexpr float nearGoal = 0.04f;

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
        return std::abs(support(block, slot) - present) < nearGoal * present;
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
        return std::clamp((std::log(unlikeSampling) - apart) / std::log(unlikeSampling / alikeSampling), 0.0f, 1.0f);
    }

    Aim m_middle;
    const Found* m_found = nullptr; ///< null: one for all
    float m_factor = 1, m_change = 1;
};

} // namespace sculpt
