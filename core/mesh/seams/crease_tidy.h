// Better triangles beside creases (mesh/README 10.3): flips and collapses that leave seams and corners where they are.
// Internal to the room.
#pragma once

#include "core/mesh/seams/crease_cut.h"

namespace mesh {

/// Flips sides within cells and collapses short ones, where the worst triangle about them gets better for it.
/// REQUIRES: as cutAtCreases.
void tidyCreases(CutMesh& cut);

} // namespace mesh
