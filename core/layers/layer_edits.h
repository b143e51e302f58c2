// Edits of models with layers: whatever changed surfels, their words follow, so that every surfel stands where its
// words show it, bit for bit (layers/README 3).
//
//     recorded   a tool or a change of shape moved surfels: what it did goes into the active layer, or the base
//     carried    surfels moved along the surface or are new: what the layers hold there is interpolated from the
//                version before, and the base takes the rest; beside the surface of before they hold nothing
//     reconciled either for a whole new version, of which only what it does not share is looked at
//     restacked  strengths, visibility or order changed: what the layers that changed touch is shown anew
//
// In parallel; the same bits at any thread count. Edits of models without layers are left alone.
#pragma once

#include "core/base/mat3.h"
#include "core/layers/layer_words.h"

namespace layers {

/// REQUIRES for all: the tree has the words of the stack; else the edit comes back as it is.
tree::Edit recorded(const tree::SurfelTree& before, tree::Edit edit, const Stack& stack);
tree::Edit carried(const tree::SurfelTree& before, tree::Edit edit, const Stack& stack);

/// Keep: what the layers hold stays with each surfel, and its base takes the rest.
enum class How { Record, Carry, Keep };
/// `after` has the words of the stack, or comes back as it is.
tree::SurfelTree reconciled(const tree::SurfelTree& before, const tree::SurfelTree& after, const Stack& stack, How how);

/// May strokes act on the active layer? Not where it is hidden or shows next to nothing of what it holds.
bool takesStrokes(const Stack& stack);

struct Restacked {
    tree::SurfelTree tree;
    std::vector<base::Box3f> changed; ///< of the blocks that changed, as they were and as they are now
};
/// `from` is what the tree shows now; both have the same layers, in any order.
Restacked restacked(const tree::SurfelTree& tree, const Stack& from, const Stack& to);

/// What the layer at place `index` shows goes into the layer below it, or into the base, and is shown as before; it
/// holds nothing then. What the own mask of the layer below hides of that one is gone where this one holds something.
/// REQUIRES: the layer below takes strokes.
tree::SurfelTree merged(const tree::SurfelTree& tree, const Stack& stack, int index);

/// The own mask of the layer at place `index` is `hides(block, slot)`, 0 to 1. Called on many threads.
Restacked masked(const tree::SurfelTree& tree, const Stack& stack, int index,
                 const std::function<float(const surfel::SurfelBlock&, int slot)>& hides);

/// The words of `after`, whose surfels are those of a version that was moved by x' = linear x + shift, moved likewise.
tree::SurfelTree mapped(const tree::SurfelTree& after, const Stack& stack, const base::Mat3d& linear,
                        const base::Vec3d& shift);

} // namespace layers
