// How far the dabs of a stroke have stretched and squeezed each block since its sampling was last seen to: what says
// where resampling is due.
//
// Two surfels that lay d apart then and lie d' apart now have the ratio d' / d (damped where d is far below the
// spacing). Of a block the largest and the smallest ratio count, over pairs of neighbours in each cluster, which point
// in all directions. A block that is carried along as one piece has 1.
#pragma once

#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <unordered_map>

namespace sculpt {

struct StretchRange {
    float least = 1, most = 1;
    void unite(const StretchRange& o) {
        least = o.least < least ? o.least : least;
        most = o.most > most ? o.most : most;
    }
    bool within(const StretchRange& limits) const { return least >= limits.least && most <= limits.most; }
};

class Stretches {
  public:
    /// After an edit of `before` that changes blocks. Returns the longest way that a surfel went.
    float note(const tree::SurfelTree& before, const tree::Edit& edit, float spacing);
    /// Over all blocks.
    StretchRange range() const;
    /// The surfels that moved, of the blocks beyond the limits; from now on these blocks count as they are.
    tree::Selection take(const tree::SurfelTree& now, const StretchRange& limits);
    void clear() { m_tracked.clear(); }

  private:
    struct Tracked {
        surfel::BlockPtr then, now;
        StretchRange range;
    };
    std::unordered_map<const surfel::SurfelBlock*, Tracked> m_tracked; ///< by `now`
};

} // namespace sculpt
