// Support radii of the distinct positions of a cloud, for work that has the cloud already.
#pragma once

#include "core/process/estimation/knn.h"
#include "core/surface/definition.h"

namespace process {

/// One reach per position, > 0 and finite. REQUIRES: a cloud of at least one position.
std::vector<float> supportsOf(const Cloud& cloud, const surface::SurfaceDefinition& definition,
                              const base::Progress& progress = {});

} // namespace process
