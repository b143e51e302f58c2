// Which faces of a closed mesh span what is no surface, so that refinement has nothing to go by (mesh/README 4.8).
// Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/delaunay/kept_closed.h"

namespace mesh {

/// By face: has it a corner on a bridge, does it face away from the surface, does none lie above its middle, or is it
/// so enclosed by such faces that nothing good could be made of it? REQUIRES: oriented faces. Throws base::Cancelled.
std::vector<bool> heldFaces(SurfaceTriangulation& mesh, const base::Progress& progress);

/// By face: does it belong to a piece of nothing but held faces, a bubble in a gap? All false where every piece is one.
std::vector<bool> bubbles(const SurfaceTriangulation& mesh, const KeptClosed& closed);

/// Flips sides between held faces in one plane, such as halving their sides leaves, where that makes the smallest angle
/// of both larger. Throws base::Cancelled.
void shapeHeld(SurfaceTriangulation& mesh, KeptClosed& closed, const base::Progress& progress);

} // namespace mesh
