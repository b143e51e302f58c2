// The boundary limit of what is left of a model when surfels went (process/README 3): cut, deleted, split off, saved as
// a part. What was closed may have a rim now.
#pragma once

#include "core/surface/surface.h"

namespace process {

/// `part`: surfels of `whole`, which keep their places. Where the definition leaves the limit to the model it is found
/// anew. A closed surface without one stays so, unless neighbours that look the same way were parted: then it ends
/// there, with a limit of its own, and with one of 0.3 h where so few surfels are in a support that these show no rim.
/// Where `learns`, what ended nowhere knows its rims from then on: an attribute for all surfels.
/// Cost: a look at the surfels that went. Throws base::Cancelled.
surface::Surface partOf(const surface::Surface& whole, tree::SurfelTree part, const base::Progress& progress = {},
                        bool learns = false);

} // namespace process
