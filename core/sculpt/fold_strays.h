// Strays: surfels that a stroke has left between sheets that face elsewhere, as the crumbs of a fold that a dab has
// pulled open again, or turned by more than a normal can follow.
//
// One is a stray where its 12 nearest contradict it, their normals having a mean cosine below -1/4 to its own, and
// fewer than 3 of its own sheet bear it: within 2.2 spacings, neither of the two more than 60 degrees above the other's
// tangent plane, normals less than 80 degrees apart. On the two sides of something thin, on rims, tips and in corners
// there are always more. (Nearest ones are counted and no ball: the spacing may be anything beside what was pulled.)
//
// A resampling takes crumbs away where it is asked for (process/README 4.1), and does not look again at what landed
// last. What lies in another sheet and contradicts all around it belongs to none, so that no later stroke merges it: it
// stays as a pit. What was a stray before the stroke, as much of the noise of a scan is, stays.
//
// Keeps both versions alive; `in` may be called from many threads.
#pragma once

#include "core/sculpt/crumbs.h"

namespace sculpt {

class FoldStrays {
  public:
    /// Of `now`; `first`: what the stroke began on.
    FoldStrays(tree::SurfelTree now, tree::SurfelTree first);
    using Slots = std::bitset<surfel::blockCapacity>;

    /// Of these slots of a block those that have become strays; what is masked wholly is none. None where normals tell
    /// no side.
    Slots in(const surfel::SurfelBlock& block, const Slots& slots, const SourceOf& sourceOf) const;

  private:
    Slots contradicted(const surfel::SurfelBlock& block, const Slots& slots) const;

    tree::SurfelTree m_now, m_first;
};

} // namespace sculpt
