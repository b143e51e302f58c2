// Points spread over faces: as evenly as dart throwing makes them, exactly on the faces, and as many as were asked for.
//
// A pool of candidates, uniform by area, is drawn with a fixed seed. They are taken in the order of their random ranks
// where none taken before is nearer than r, which shrinks from round to round until enough are taken [McCool92]. Cells
// of side r are worked in 27 groups, within which no two are neighbours [Wei08]: the same points at any thread count
// (mesh/README 8.3).
//
// Distances are those of a sheet: d^2 + 3 (n.d)^2, and faces that look away from each other (by more than 120 degrees)
// do not see each other, so that both sides of a thin wall get all their points. Across an edge that stays sharp,
// points may come two and a half times as near as within a patch: a narrow strip has a row of its own beside its
// neighbours'.
//
// Borders may come first, with rows of their own (border_rows.h).
//
// Where a density asks for several spacings, distances are taken over the spacing at the candidate. Candidates lie in
// cells of the power of two above their spacing then, and see those of the powers next to it.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_density.h"

namespace mesh {

struct Spreading {
    const InnerPlaces* inside = nullptr;      ///< no points at places that are; null: nothing is
    const FaceDensity* density = nullptr;     ///< how they are spread, up to a factor; null: evenly
    std::span<const std::uint32_t> patches{}; ///< of each triangle the one between sharp edges; empty: none are sharp
    bool rows = false;                        ///< along borders
};

/// `count` points, or a few percent fewer where the faces are too small for so many. In the order of cells. REQUIRES:
/// an area above 0. Throws base::Cancelled.
std::vector<FacePoint> spreadPoints(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                                    std::size_t count, const base::Progress& progress = {}, const Spreading& how = {});

} // namespace mesh
