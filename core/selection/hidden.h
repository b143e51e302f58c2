// What is hidden of a model: surfels that are neither drawn nor met by rays, that no tool moves and that is not
// selected unless asked for. Nothing of it is lost: it is an attribute like the selection (field.h), so that files,
// undo and hashes hold it, and whatever works on whole models works on it (selection/README 10).
//
//     shownOf      what pictures, pointers and strokes have in place of the model
//     grafted      what a stroke did to that, done to the model
#pragma once

#include "core/selection/field.h"
#include "core/surface/surface.h"

namespace selection {

/// What there is to do about it, by what is selected, masked or hidden now. `Selected`, `Rest` and `Masked` hide more.
enum class Hiding { Selected, Rest, Masked, Swap };
/// What comes to be hidden is no longer selected. Throws base::Error where nothing would be shown.
tree::SurfelTree hidden(const tree::SurfelTree& tree, Hiding which);
/// Everything is shown, and the attribute gone: the bits are those of a model of which nothing was ever hidden.
tree::SurfelTree allShown(const tree::SurfelTree& tree);

/// Without what is hidden, everything else bit for bit. It ends where that begins: a closed surface gets a boundary
/// limit. Cost: a look at every surfel's word, at the layout where nothing was ever hidden; blocks of which nothing is
/// hidden are shared.
surface::Surface shownOf(const surface::Surface& surface);

/// `whole` with that done to it that led from `before`, which is shownOf(whole)'s tree, to `after`: what is hidden
/// keeps every bit. Cost: the blocks that differ. REQUIRES: layouts of the same words.
tree::SurfelTree grafted(const tree::SurfelTree& whole, const tree::SurfelTree& before, const tree::SurfelTree& after);

/// The highest step that a stroke on what is shown left or made higher, in spacings there, to what is hidden beside it
/// in `whole`, and where; below 1/2 nothing is to be seen. Cost: the blocks that differ.
struct Step {
    double spacings = 0, height = 0; ///< model units
    base::Vec3f place;
};
Step stepBesideHidden(const tree::SurfelTree& whole, const tree::SurfelTree& before, const tree::SurfelTree& after);

/// How many hidden surfels of `before` are not in `after`, at the same place with the same normal and support. Cost:
/// the blocks that differ; nothing where nothing is hidden.
std::size_t hiddenChanged(const tree::SurfelTree& before, const tree::SurfelTree& after);

/// `after` with what is hidden as it was before. REQUIRES: the same surfels in the same blocks, and the same words.
tree::SurfelTree hiddenSpared(const tree::SurfelTree& before, const tree::SurfelTree& after);

} // namespace selection
