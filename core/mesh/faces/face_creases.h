// Cells from the sharp edges of a mesh (cells/README 1.3): samples of the faces get labels of the patches that they lie
// on, and at sharp edges the cell across as partner.
//
//     chains              sharp edges that are no noise                      crease_chains.h
//     patches             those of too few samples go to the neighbour that they turn to least
//     edges that end      of which both sides are one patch: each side becomes a band of its own, smooth to the rest of
//                         the face, sharp to the other side, less and less towards the end      crease_bands.h
//     near sheets         of one face, beside a narrow wall: told apart                         near_sheets.h
//     labels              core/cells/crease_labels.h
#pragma once

#include "core/mesh/faces/crease_chains.h"
#include "core/mesh/faces/face_points.h"
#include "core/surfel/surfel.h"

namespace mesh {

/// REQUIRES: `samples` are those of `points`, about as far apart as `spacings` tells of each, or one for all.
/// Nothing happens without chains.
void labelCreases(const FaceTopology& topology, const CreaseChains& chains, std::span<const FacePoint> points,
                  std::span<const double> spacings, surfel::SurfelList& samples);

} // namespace mesh
