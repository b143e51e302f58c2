// Which parts of a model go as a whole when it is put together with another one (solid/README 2.7): somebody who joins
// two models may not see that a part of one has been swallowed. Inside this room only.
#pragma once

#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <functional>

namespace solid {

/// How many parts lie wholly in `gone`. A part is what is linked: nearer to each other than 2.2 spacings of the sparser
/// one, whichever way it faces, so that edges of any angle and both sides of what is thin are of one part. Cost: what
/// is gone. The same at any thread count.
std::size_t wholeParts(const tree::SurfelTree& tree, const tree::Selection& gone);

/// The same for what an edit removes.
std::size_t partsThatGo(const tree::SurfelTree& tree, const tree::Edit& edit);
/// And for the surfels of which `gone` holds, by their numbers.
std::size_t partsWhere(const tree::SurfelTree& tree, const std::function<bool(std::size_t)>& gone);

} // namespace solid
