// What is done with the part of a model that is selected: taken out, kept alone, coloured, turned over
// (selection/README 7). Surfels with a value of at least 1/2 are the part; colours go by the value itself.
#pragma once

#include "core/base/progress.h"
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

/// `part` of a model's surfels as a surface (process::partOf). What ended nowhere knows its rims from then on, by an
/// attribute; but not where something is hidden, whose bits would be others then.
surface::Surface asPart(const surface::Surface& whole, tree::SurfelTree part, const base::Progress& progress = {});

/// Colours moved towards one: by `strength`, 0 to 1, times the selection. Alpha stays.
tree::SurfelTree coloured(const tree::SurfelTree& tree, surfel::Colour colour, double strength, Limit limit);

/// Each takes the colour that `colourFor` makes of its own, `strength` of the way; alpha stays.
tree::SurfelTree recoloured(const tree::SurfelTree& tree,
                            const std::function<surfel::Colour(surfel::Colour)>& colourFor, double strength,
                            Limit limit);

/// Normals turned over, of surfels selected or of all.
tree::SurfelTree flipped(const tree::SurfelTree& tree, Limit limit);

} // namespace selection
