// Samples that spread themselves over a model while one watches: dark discs on its surface, in the same tree, so that
// every renderer shows them from every side.
#pragma once

#include "core/reduce/sites.h"
#include "ui/work/snapshot.h"

namespace ui {

/// What the picture shows of `before` with the floaters on it, each as wide as a part of its room, so that their
/// density is seen. The model itself (Snapshot::surface) is as before.
Snapshot withFloaters(const Snapshot& before, const reduce::Sites& floaters);

} // namespace ui
