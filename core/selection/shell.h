// A shell of a thickness of what is selected, or of a whole open scan (selection/README 9): its surface, the same
// surface as far away as the shell is thick and turned over, and walls along the boundaries between them.
#pragma once

#include "core/base/progress.h"
#include "core/selection/parts.h"

namespace selection {

enum class ShellSide { In, Out };

/// A model of its own in which nothing is masked or selected. `thickness` > 0, in model units. Throws base::Error where
/// normals have no sides or fewer than 16 surfels are selected.
surface::Surface shellOf(const surface::Surface& surface, double thickness, ShellSide side, Limit limit,
                         const base::Progress& progress = {});

} // namespace selection
