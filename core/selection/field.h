// A value of each surfel from 0 to 1 that chooses, protects or hides: the selection, the sculpt mask beside it, and
// what is hidden (hidden.h). What this room does to fields it does to all alike (selection/README 1).
//
// The mask is a fixed channel. The others are attributes of float32 named "selection" and "hidden", which a model has
// from the first time that something is selected or hidden; before, they are 0 everywhere. A surfel is *selected*,
// *hidden*, where the value is at least 1/2. New versions share every block in which nothing changed.
#pragma once

#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <array>
#include <functional>
#include <span>

namespace selection {

enum class Field { Selection, Mask, Hidden };

/// Of attributes: not the mask's.
constexpr const char* attributeName(Field field) {
    return field == Field::Hidden ? "hidden" : "selection";
}
constexpr float half = 0.5f;

/// The channel of blocks that holds a field; -1 where no block has it. Throws base::Error where the model has an
/// attribute of the selection's name that is no float; one of "hidden" hides nothing.
int channelOf(const surfel::AttributeLayout& layout, Field field);

/// Of one block; 0 past its end.
using BlockValues = std::array<float, surfel::blockCapacity>;
void read(const surfel::SurfelBlock& block, int channel, BlockValues& out);

/// Of one surfel. `channel` as channelOf gives it.
inline float valueAt(const surfel::SurfelBlock& block, int channel, int slot) {
    return channel < 0 ? 0.0f : block.channel(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize];
}

/// Changes the values of one block in place; called on any thread, once for each block.
using Rewrite = std::function<void(std::uint32_t number, const surfel::SurfelBlock& block, BlockValues& values)>;
/// The version in which `rewrite` has changed the field: in all blocks, or in those named, ascending.
/// `grain` blocks in a row on one thread: few where a block is much work, so that it can be cancelled.
tree::SurfelTree rewritten(const tree::SurfelTree& tree, Field field, const Rewrite& rewrite, std::size_t grain = 16);
tree::SurfelTree rewritten(const tree::SurfelTree& tree, Field field, std::span<const std::uint32_t> numbers,
                           const Rewrite& rewrite, std::size_t grain = 16);

/// All blocks by their numbers; the version keeps them alive.
std::vector<const surfel::SurfelBlock*> blocksOf(const tree::SurfelTree& tree);

/// The surfels whose value is at least 1/2.
tree::Selection selectedIn(const tree::SurfelTree& tree, Field field = Field::Selection);

/// How what was found joins what was selected before.
enum class Mode { Replace, Add, Subtract, Intersect };
tree::SurfelTree combined(const tree::SurfelTree& tree, const tree::Selection& found, Mode mode);

} // namespace selection
