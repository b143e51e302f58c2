// Parts of a surface that do not know of each other and are sampled each at a spacing of its own, as the bodies of a
// scene are: one size of triangles would lose the small ones, or cut the large ones into millions (mesh/README 3.15).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Together the surface: each part has the surfels that reach each other's places, with their supports, over however
/// many steps; parts of about the same spacing are one. Just one where nothing stands apart, or where all is about as
/// dense. Parts of too few surfels to tell a spacing go with the largest one. Throws base::Cancelled.
std::vector<surface::Surface> partsOf(const surface::Surface& surface, const base::Progress& progress = {});

/// REQUIRES: both have the same attributes.
void append(Mesh& mesh, const Mesh& more);

} // namespace mesh
