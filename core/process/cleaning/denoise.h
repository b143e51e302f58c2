// Noise taken out of positions without shrinking the model (process/README 11.3).
//
// Each point is moved onto quadrics fitted to more and more of its neighbours, along their plane's normal, as long as
// the larger fit agrees with the smaller ones within their noise (the intersection of confidence intervals,
// [Goldenshluger97, Katkovnik06]): over flat and gently bent parts many neighbours average the noise away, at relief
// that stands out of it few do. Quadrics reproduce spheres, so that nothing shrinks.
#pragma once

#include "core/process/neighbours/knn.h"

namespace process {

/// The standard deviation of positions across the surface, of each point and in the middle of all.
struct NoiseLevel {
    std::vector<float> at;
    double middle = 0;
};

/// From what quadrics through 30 neighbours leave over, corrected for what they follow; the median of some hundred
/// neighbours, so that edges do not count as noise. In parallel, the same bits at any thread count.
NoiseLevel estimateNoise(const Cloud& cloud, const base::Progress& progress = {});

struct Denoised {
    std::vector<base::Vec3f> positions, normals; ///< of the cloud's positions; normals on the side of those given
};

/// `noise`: one per position. `normals`: one each; where `oriented`, neighbours that face away are of another wall and
/// do not count. In parallel, the same bits at any thread count.
Denoised denoised(const Cloud& cloud, std::span<const base::Vec3f> normals, bool oriented, std::span<const float> noise,
                  const base::Progress& progress = {});

} // namespace process
