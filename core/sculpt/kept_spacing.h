// The sampling that a stroke is to keep: for every surfel the spacing that was around it before the stroke.
//
//     m   measured: from the 6 nearest that face alike (all of the 14 nearest where supports vary, or where surfels lie
//         by chance), around the surfel's origin (stretches.h), on the version that the stroke began on
//     h   what the surfel's support was made for; where a model's supports are made otherwise on the whole, that times
//         their median ratio
//     s = h within [m / 1.25, 1.25 m] where the supports around are alike, else m
//
// So what earlier strokes have drawn apart, each by too little to resample, adds up to no more than a quarter, and
// noise of m does not show on even models; in fine detail and its surroundings, whose supports are graded from one to
// the other, the sampling that is there decides.
//
// A value; const functions may run on any thread.
#pragma once

#include "core/sculpt/block_memo.h"
#include "core/sculpt/stretches.h"
#include "core/surface/surface.h"
#include "core/surfel/shape.h"
#include "core/tree/nearest_together.h"

#include <optional>

namespace sculpt {

class KeptSpacing {
  public:
    KeptSpacing() = default;
    /// `atContact`: the spacing where the stroke begins, for models with one support for all.
    KeptSpacing(surface::Surface first, float atContact);

    /// Measures, on the first version, around all surfels of these blocks, unless that has been done, and keeps what
    /// was found. In parallel.
    void measure(std::span<const surfel::BlockPtr> blocks);
    /// Forgets what was found for others than these.
    void keepOnly(std::span<const surfel::BlockPtr> blocks) { m_known.keepOnly(blocks); }
    /// Measures some surfels at once, best of a cluster; one thread.
    class Search {
      public:
        explicit Search(const KeptSpacing& kept);
        /// REQUIRES: at most 16 slots, as many answers.
        void at(const surfel::SurfelBlock& block, std::span<const int> slots, std::span<LocalSpacing> out);
        /// The same of a place whose nearest surfels are known: `asked` of them, or all there are.
        LocalSpacing among(std::span<const tree::Neighbour> near, const base::Vec3f& n) const;
        /// So many, so that the other side of something thin may be among them.
        static constexpr std::size_t asked = 14;

      private:
        const KeptSpacing& m_kept;
        tree::NearestTogether m_around;
    };
    /// m at surfels of `origin`, on the first version. Known or measured now. REQUIRES: at most 16 slots.
    void measured(const surfel::SurfelBlock& origin, std::span<const int> slots, Search& search,
                  std::span<LocalSpacing> out) const;
    LocalSpacing measured(const surfel::SurfelBlock& origin, int slot) const;
    /// The support of a surfel; of an ellipsoid, that of the ball of its area.
    float supportOf(const surfel::SurfelBlock& block, int slot) const { return surfel::ballOf(block, slot, m_shape); }
    /// s where m is `measured`, of a surfel with this support.
    float target(const LocalSpacing& measured, float support) const;
    /// What a support of this size is made for.
    float madeFor(float support) const;
    /// How the measured spacing stands to that on the whole, where the two agree as well.
    float typical() const { return m_typical; }
    const surface::Surface& first() const { return *m_first; }

  private:
    std::optional<surface::Surface> m_first;
    float m_atContact = 0;
    int m_shape = 0;     ///< channel of the shapes of supports
    float m_ratio = 1;   ///< of the measured spacing to what supports are made for; 1 where they agree
    float m_typical = 1; ///< what m_ratio leaves of that ratio
    bool m_same = false; ///< one support for all
    BlockMemo<LocalSpacing> m_known;
};

} // namespace sculpt
