// Crumbs: small pieces that no surfels make (mesh/README 3.10).
#pragma once

#include "core/mesh/finish/orient_mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Removes pieces of less area than `surfelsOfPiece` surfels cover where they lie, closed ones only where no more than
/// three surfels lie on them; returns how many pieces. What is nothing but crumbs stays. Vertices stay; `pieces` is
/// void afterwards. REQUIRES: kinds.
std::size_t dropCrumbs(Mesh& mesh, const Orientation& pieces, const surface::Surface& surface);

/// Of which a sheet is made at least.
constexpr double surfelsOfPiece = 6;

} // namespace mesh
