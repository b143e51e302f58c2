// Colours brighter, darker, with more contrast, or without a cast: of what is selected or of everything
// (selection/README 7).
//
//     v' = 255 ((v - black) / (white - black))^(1 / gamma)          of each channel, after the gains
//
// Gains are factors of linear light; levels are numbers of the file, 0 to 255, as programs for pictures have them.
#pragma once

#include "core/selection/parts.h"

namespace selection {

struct Levels {
    double black = 0, white = 255, gamma = 1; ///< black < white
    base::Vec3d gain{1, 1, 1};

    surfel::Colour operator()(surfel::Colour colour) const; ///< alpha stays
};

/// What makes a mean colour of linear light grey, and as bright as before. Ones where a channel is dark.
base::Vec3d greyGains(const base::Vec3d& linearMean);
/// Mean linear light of surfels selected, or of all, but for those that are clipped or black.
base::Vec3d meanLight(const tree::SurfelTree& tree, Limit limit);
/// Of the 16 surfels nearest to a place, in stored coordinates.
base::Vec3d meanLightAt(const tree::SurfelTree& tree, const base::Vec3d& place);
/// Levels that half a percent of all channels are below, and above, with gains that come first.
std::pair<double, double> usedRange(const tree::SurfelTree& tree, Limit limit, const base::Vec3d& gain);

/// Soft selections shade into what is around. REQUIRES: colours.
tree::SurfelTree levelled(const tree::SurfelTree& tree, const Levels& levels, Limit limit);

} // namespace selection
