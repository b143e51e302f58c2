// Where an open model ends once something was drawn out of it: where it ended before, moved with what moves, and where
// walls end (solid/README 4.4). Inside this room only.
#pragma once

#include "core/base/progress.h"
#include "core/solid/extrude/part.h"
#include "core/solid/loops/loop.h"
#include "core/surface/curves/boundary_curves.h"

namespace solid {

/// Nothing where the model ends nowhere, where its limit is not left to it, and where its boundary curves do not close:
/// then its limit goes on to tell. `part`: goes along `way`.
std::vector<base::Vec3d> rimsWithPart(const surface::Surface& surface, const Part& part, const base::Vec3d& way,
                                      const base::Progress& progress = {});

/// The same of a wall along one of the curves: the rim of that is where the wall ends, `ways` from places of `loop`.
std::vector<base::Vec3d> rimsWithWall(const surface::Surface& surface, std::span<const surface::BoundaryCurve> curves,
                                      std::size_t number, const Loop& loop, std::span<const base::Vec3d> ways);

} // namespace solid
