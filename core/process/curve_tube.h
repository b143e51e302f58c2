// The tube in which a curve is shown, hit by rays and exported: rings of surfels around the feet of its points.
//
// A surfel's radius is its attribute `radius` (model units) where the model has one, else an eighth of its support,
// which is a little less than the points' spacing. Between neighbours radii vary linearly, and normals tilt with them.
// Colours and masks are those of the curve's surfels. Points whose feet fail or lie beyond the curve's ends have no
// ring.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

namespace process {

/// REQUIRES: the definition's manifold is Curve. In parallel; the same bits at any thread count. Throws
/// base::Cancelled.
surface::Surface tubeAround(const surface::Surface& curve, const base::Progress& progress = {});

/// What stands for a model in pictures and under rays: itself, or the tube around a curve.
surface::Surface shownAs(const surface::Surface& model, const base::Progress& progress = {});

} // namespace process
