// What is done with the part of a model that is selected: taken out, kept alone, coloured, turned over
// (selection/README 7). Surfels with a value of at least 1/2 are the part; colours go by the value itself.
#pragma once

#include "core/selection/field.h"
#include "core/surface/surface.h"

namespace selection {

/// What an operation changes: what is selected, in the measure of the selection, or everything.
enum class Limit { Selection, Everything };
/// How much of a change a surfel gets under a limit; `channel` as channelOf gives it.
inline double weightUnder(Limit limit, const surfel::SurfelBlock& block, int channel, int slot) {
    return limit == Limit::Everything ? 1.0 : static_cast<double>(valueAt(block, channel, slot));
}

/// Without the selected surfels, or without all others that are shown. What stays keeps every bit: supports, too, so
/// that a rim lies where it was cut. Throws base::Error where fewer than 16 would be left.
tree::SurfelTree withoutSelected(const tree::SurfelTree& tree);
tree::SurfelTree withoutRest(const tree::SurfelTree& tree);

/// The selected surfels, or all others, as a list in tree order in which nothing is selected.
surfel::SurfelList partOf(const tree::SurfelTree& tree, bool selected);

/// Colours moved towards one: by `strength`, 0 to 1, times the selection. Alpha stays.
tree::SurfelTree coloured(const tree::SurfelTree& tree, surfel::Colour colour, double strength, Limit limit);

/// Normals turned over, of surfels selected or of all.
tree::SurfelTree flipped(const tree::SurfelTree& tree, Limit limit);

} // namespace selection
