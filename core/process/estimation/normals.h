// Normals of raw points: estimated from the k nearest by weighted covariance, then oriented consistently.
#pragma once

#include "core/base/progress.h"
#include "core/surfel/surfel.h"

namespace process {

/// Unit normals without a meaningful sign; sets layout->normals. In parallel, deterministic.
void estimateNormals(surfel::SurfelList& points, int neighbours = 18, const base::Progress& progress = {});

/// Flips normals so that all agree (orientation/global_orientation.h); sets layout->oriented. On a surface that has no
/// two sides all stays as it is and false is returned. In parallel, deterministic.
/// `neighbours`: at most 12.
bool orientNormals(surfel::SurfelList& points, int neighbours = 12, const base::Progress& progress = {});

} // namespace process
