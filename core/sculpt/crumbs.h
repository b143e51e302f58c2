// Crumbs: what a stroke has left of a sheet where nothing bears it any more, such as single surfels beside a hole.
//
// Surfels are of one sheet where they are at most 2.2 spacings apart and face alike (sculpt/README 3.3). A crumb is a
// sheet of fewer than 6 where there was a larger one before the stroke; what was as small then, such as the noise of a
// scan, stays. Strays of folds (fold_strays.h) go with them.
#pragma once

#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <functional>

namespace sculpt {

/// What is known of a surfel of the present version.
struct CrumbSource {
    base::Vec3f origin; ///< where it was when the stroke began
    float spacing = 0;  ///< there
    float made = 0;     ///< the one that its support is made for
};
using SourceOf = std::function<CrumbSource(const surfel::SurfelBlock&, int slot)>;

/// Removes crumbs among the candidates of `now`. `first`: what the stroke began on. At least 16 surfels stay. In
/// parallel; `sourceOf` is called from many threads.
tree::Edit dropCrumbs(const tree::SurfelTree& now, const tree::SurfelTree& first, const tree::Selection& candidates,
                      const SourceOf& sourceOf);

} // namespace sculpt
