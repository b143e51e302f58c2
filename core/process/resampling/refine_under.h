// Refining before a brush works: where few samples carry the shape, their supports may be large against the brush, and
// what it does would be smeared over all of them. They give way to finer ones on the same surface
// (process/README 4.11).
#pragma once

#include "core/process/resampling/resample.h"

#include <optional>

namespace process {

/// What becomes of an edit before it is applied; nothing: it stays as it is.
using Along = std::function<tree::Edit(const tree::SurfelTree&, tree::Edit)>;

/// Under a brush at `centre` supports with semi-axes beyond radius / 2 become balls for a spacing of radius / 4.5,
/// which grows outwards; they and those around them are fitted to the surface that was there; all else keeps every bit.
/// Nothing where nothing is to be done, for models of many neighbours, with one support for all, without oriented
/// normals, or where cells meet. The same bits at any thread count.
std::optional<surface::Surface> refinedUnder(const surface::Surface& surface, const base::Vec3f& centre, float radius,
                                             const Along& along = {});

} // namespace process
