// The spacing at which as many surfels cover a version as do: s^2 is the area that each has there. The spacing that a
// stroke keeps (kept_spacing.h) is told by too few where surfels lie by chance: it varies by a seventh from one to the
// next, what is too small makes surfels, and a whole stroke of relax made a fifth more. So how far the 31st is counts
// as well, on the same side and in all directions: the larger of the two, since what is too large for one takes hardly
// any.
//
// What is found is kept by the block. A value; const functions may run on any thread.
#pragma once

#include "core/sculpt/block_memo.h"
#include "core/sculpt/kept_spacing.h"

namespace sculpt {

class AreaSpacing {
  public:
    /// `atContact`: as for KeptSpacing.
    AreaSpacing(const surface::Surface& first, float atContact) : m_kept(first, atContact) {}

    /// Measures around all surfels of these blocks, unless that has been done. In parallel.
    void measure(std::span<const surfel::BlockPtr> blocks);
    /// Forgets what was found for others than these.
    void keepOnly(std::span<const surfel::BlockPtr> blocks) { m_known.keepOnly(blocks); }
    /// Known or measured now.
    float at(const surfel::SurfelBlock& block, int slot) const;

  private:
    class Search;
    KeptSpacing m_kept;
    BlockMemo<float> m_known;
};

} // namespace sculpt
