// What `query` answers on curves (core/surface/curves/curve.h), in the columns that surfaces use.
#pragma once

#include "app/query_columns.h"

namespace app {

/// value |F|; normal F / |F|, away from the curve; gradient that of |F|; curvature k1 = |K| along the tangent, k2 = 0,
/// d2 the binormal; tangent and curvature vector as they are. Always in double; in parallel.
void answerOnCurve(const surface::Surface& curve, const Question& question, std::span<const base::Vec3d> x,
                   std::span<Answer> out);

} // namespace app
