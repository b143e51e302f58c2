// Words that show the surfels of a block where they stand (layers/README 3). Internal to this room.
#pragma once

#include "core/layers/inherited.h"
#include "core/layers/layer_edits.h"
#include "core/layers/shown_cluster.h"

namespace layers {

/// What all blocks of an edit have in common.
struct SettleRules {
    Channels channels;
    std::vector<float> weights;
    int target = -1; ///< recording into this layer; -1: below all of them
    How how = How::Keep;
};

/// In place; a fresh block, sealed afterwards. `inheritance`: where surfels that moved along the surface look; null
/// where none does. Returns whether any word had to change.
bool settle(surfel::SurfelBlock& block, const SettleRules& rules, Inheritance* inheritance);

/// A block whose words show it as it stands; null where they do already.
surfel::BlockPtr settled(const surfel::SurfelBlock& block, const SettleRules& rules, Inheritance* inheritance);

} // namespace layers
