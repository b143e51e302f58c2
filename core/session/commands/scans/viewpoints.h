// Where the scanners of a model stood, as its file tells it: readers of grids leave the comments "viewpoint x y z ..."
// or, one for each scan, "scan NAME viewpoint x y z ..." (io/README). Inside this room.
#pragma once

#include "core/process/cleaning/mixed_pixels.h"
#include "core/selection/affine.h"
#include "core/session/document.h"

#include <optional>

namespace session {

/// In the coordinates of the surfels, which come as a list of the active model's. Nothing where the file does not tell
/// them for all points. Points of an ordered grid without a comment were seen from the origin, as their formats say.
std::optional<process::Eyes> eyesOf(const Document& document, const surfel::SurfelList& points);

/// The same comments once all of a model has moved: the scanners move along. `map`: of the file's coordinates. How the
/// scanners were turned is forgotten, as nothing here asks for it.
std::vector<std::string> movedViewpoints(std::vector<std::string> comments, const surfel::AttributeLayout& layout,
                                         const selection::Affine& map);

} // namespace session
