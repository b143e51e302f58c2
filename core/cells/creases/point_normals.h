// Normals for finding creases: those of planes through neighbours on one side of an edge, and how much noise the points
// have (cells/README 7.1).
#pragma once

#include "core/base/progress.h"
#include "core/cells/creases/surfel_links.h"

namespace cells {

struct PointNormals {
    std::vector<base::Vec3f> normals; ///< on the side of the surfels' own
    double noise = 0;                 ///< standard deviation of points from the surface, in spacings
};

/// From positions; of the surfels' normals only the side counts. In parallel. Throws base::Cancelled.
PointNormals pointNormals(const SurfelLinks& links, const base::Progress& progress = {});

} // namespace cells
