// What surfels know of layers, as further attributes of float32 (surfel/README 3), under these names:
//
//     layer_base_x _y _z _nx _ny _nz _support      place, normal and support on the surface below all layers
//     layer_3_x _y _z                              what layer 3 displaces: d, in the frame of the surface below it
//     layer_3_nx _ny _nz                           what it adds to the area vector: e (layers/README 2)
//     layer_3_support                              by how much it widens the support: q
//     layer_3_mask                                 its own mask: 0 shows it, 1 hides it
//
// The words of one group stand next to each other in the layout. Blocks hold them as channels of their clusters.
#pragma once

#include "core/layers/stack.h"
#include "core/tree/surfel_tree.h"

#include <functional>
#include <optional>

namespace layers {

/// Words of the base: place, normal, support. Of a layer: d, e, q and its mask, by their places.
constexpr int baseWords = 7, layerWords = 8;
enum LayerWord : int { Displacement = 0, Area = 3, Widening = 6, OwnMask = 7 };

/// Where the groups begin, as channels of clusters.
struct Channels {
    int base = 0;
    std::vector<int> layers; ///< in the order of the stack

    /// Nothing where the layout lacks a word of the stack.
    static std::optional<Channels> of(const surfel::AttributeLayout& layout, const Stack& stack);
};

/// Can these words be shown? Those of a file are claims: they are finite, and no place is farther off than a thousand
/// diagonals of the model. REQUIRES: the layout has the words.
bool areSound(const tree::SurfelTree& tree, const Channels& channels);

/// The same model with the words of one more layer, which did nothing yet; with those of the base where the stack was
/// empty. Throws base::Error where a name is taken by an attribute of something else.
tree::SurfelTree withWords(const tree::SurfelTree& tree, const Stack& before, std::uint32_t id);
/// Without the words of a layer; without those of the base where `after` is empty. What it displaced must be gone.
tree::SurfelTree withoutWords(const tree::SurfelTree& tree, const Stack& after, std::uint32_t id);

/// The same surfels under another layout: attributes of the same name keep their words, others become 0. `fill` may
/// write the new block's further words; it runs on many threads.
tree::SurfelTree laidOut(const tree::SurfelTree& tree, const surfel::AttributeLayoutPtr& layout,
                         const std::function<void(surfel::SurfelBlock&)>& fill = {});

/// The layout without the attributes of some names.
surfel::AttributeLayoutPtr layoutWithout(const surfel::AttributeLayout& layout,
                                         const std::function<bool(const std::string&)>& gone);

} // namespace layers
