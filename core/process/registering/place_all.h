// Several scans to their places without any hint, one after the other: the one that fits best to those that have a
// place goes next (process/README 13.2).
#pragma once

#include "core/process/registering/align.h"

#include <span>
#include <string>

namespace process {

/// Sets the poses of all but the first. `names`: one each, for errors. The same bits at any thread count. Throws
/// base::Error naming a scan of which nothing looks like a part of the others, base::Cancelled.
void placeAll(std::span<Placed> models, std::span<const std::string> names, const base::Progress& progress = {});

} // namespace process
