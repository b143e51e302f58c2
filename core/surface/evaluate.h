// Evaluation as the room's own loops call it, in either precision: at a position, with clusters gathered already or
// not.
#pragma once

#include "core/surface/clusters.h"
#include "core/surface/surface.h"

namespace surface {

Evaluationf evaluateIn(const Surface& surface, ClusterSpan clusters, const base::Vec3f& x, Need need,
                       const Hint& hint = {});
Evaluationd evaluateIn(const Surface& surface, ClusterSpan clusters, const base::Vec3d& x, Need need,
                       const Hint& hint = {});

template <class T>
Evaluation<T> evaluateAt(const Surface& surface, const base::Vec3<T>& x, Need need, const Hint& hint = {}) {
    const ScratchClusters clusters(surface.tree(), x);
    return evaluateIn(surface, clusters.span(), x, need, hint);
}

} // namespace surface
