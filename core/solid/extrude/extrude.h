// Matter drawn out (solid/README 4.4): a part of a model moved away from the rest, with walls that close the step, or a
// wall along a boundary loop.
//
//     findBoundaryCurves       surface/curves/boundary_curves.h
//     evenLoop                 loop.h
//     wallAlong                extrude_wall.h
//     crossingsOf              crossings.h
//     rimsWithPart             extruded_rims.h
//     creasedWhere             link_creases.h
//
// Surfels that stay keep every bit, but for labels beside the edges. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/solid/extrude/crossings.h"
#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <optional>

namespace solid {

struct ExtrudeOptions {
    double length = 0;                    ///< model units; below 0 against the direction
    std::optional<base::Vec3d> direction; ///< unit; none: along the normal
    bool creases = true;                  ///< label both sides of the edges, so that they stay sharp
    bool merge = false; ///< where what moves runs through the model, make one solid of both (of selections alone)
};

struct Extruded {
    surface::Surface surface;
    std::size_t moved = 0;  ///< surfels
    std::size_t walls = 0;  ///< surfels that came
    std::size_t atEdge = 0; ///< surfels beside the edges, where these are creases
    Crossings crossings;    ///< with the model, on the way
    std::size_t inside = 0; ///< surfels that merging took out
};

/// What is selected goes along the direction, or its mean normal, as one piece; where it bordered on the rest walls
/// lead there, so that what was closed stays closed. Surfels next to the border are on the side of it where they lie,
/// ragged as the selection may be. Throws base::Error where the length is 0, where nothing says which way, where the
/// selection has no border or nothing is left beside it; base::Cancelled.
Extruded extrudeSelected(const surface::Surface& surface, const tree::Selection& selected,
                         const ExtrudeOptions& options, const base::Progress& progress = {});

/// A wall along one boundary loop, by number, or the only one. Without a direction it stands on the surface, along the
/// normals there. Throws base::Error where the length is 0, where there is no such loop, it touches itself or does not
/// close, and where the wall would lie on the surface; base::Cancelled.
Extruded extrudeLoop(const surface::Surface& surface, std::optional<std::size_t> loop, const ExtrudeOptions& options,
                     const base::Progress& progress = {});

} // namespace solid
