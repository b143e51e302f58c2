// Facts about a surface that the meshers need at every step.
#pragma once

#include "core/surface/surface.h"

namespace mesh {

struct SurfaceTraits {
    explicit SurfaceTraits(const surface::Surface& surface);

    bool oriented;          ///< do the surfels' normals give f a sign?
    bool closed;            ///< oriented, and without a boundary limit: it bounds a solid
    bool sided;             ///< closed, or away from rims that it knows (surface/rims.h): it has an inside
    bool continuous;        ///< has f no step between near sheets, so that nobody needs to choose one?
    bool distances;         ///< does |f| grow like a distance? With covariance frames it does not
    double spacingsPerUnit; ///< s / h
};

} // namespace mesh
