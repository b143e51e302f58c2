// How finely each connected piece of faces is to be sampled: as if it stood alone in its file, but for what all of them
// may cost (mesh/README 8.3).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_density.h"

namespace mesh {

struct PieceSpacings {
    std::vector<double> spacings;    ///< of each piece
    std::vector<double> walls;       ///< the thinnest of each, infinity where that is some spacings and more
    std::vector<SpacedPlace> places; ///< spread over the pieces

    void scale(double by) {
        for (double& each : spacings)
            each *= by;
        for (SpacedPlace& each : places)
            each.spacing *= by;
    }
};

/// `count`: of all samples, shared out among the pieces; 0: what they need. Throws base::Cancelled.
PieceSpacings pieceSpacings(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                            const InnerPlaces& inside, std::size_t count, const base::Progress& progress = {});

/// Most samples of pieces of these spacings, which may ask for more at one another.
double mostSamplesOf(const FaceTopology& topology, std::span<const double> spacings);

} // namespace mesh
