// Whether points draw lines in a plane, as plans and profiles of cuts do: curves, and no surface.
#pragma once

#include "core/tree/surfel_tree.h"

namespace process {

/// The model is flat as a whole, and of its places a good part has all its nearest along one line. Surfaces by chance
/// have hardly any such places. A flat sheet that was scanned in lines far apart is taken for a drawing, too. From up
/// to 1024 surfels.
bool drawsLines(const tree::SurfelTree& tree);

} // namespace process
