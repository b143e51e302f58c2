// What patches and sheets must not run into: the model, each other, themselves.
#pragma once

#include "core/solid/loops/patch.h"
#include "core/surface/surface.h"

namespace solid {

/// Does a patch come within 0.7 spacings of the model's surfels, other than at its loop? It may have more points along
/// that, where its edges were halved.
bool meetsModel(const surface::Surface& surface, const Loop& loop, const Patch& patch);

/// Do two patches come within 0.7 spacings of each other?
bool meet(const Patch& a, const Patch& b);

/// Does a patch pass through itself? It has triangles of even size, so that vertices come near each other only there.
bool crossesItself(const Patch& patch);

} // namespace solid
