// How finely each connected piece of faces is to be sampled: as if it stood alone in its file, but for what all of them
// may cost, and more finely where it is thin (mesh/README 8.3).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_density.h"

namespace mesh {

/// Of a place on a piece: what is behind it, infinity where that is some spacings away and more.
struct ProbedWall {
    float wall = 0;
    std::uint32_t piece = 0;
};

struct PieceSpacings {
    std::vector<double> spacings;    ///< of each piece
    std::vector<SpacedPlace> places; ///< spread over the pieces: what they ask of each other
    std::vector<SpacedPlace> finer;  ///< places that ask for less than their piece
    std::vector<ProbedWall> walls;   ///< of each of the places

    void scale(double by) {
        for (double& each : spacings)
            each *= by;
        for (auto* all : {&places, &finer})
            for (SpacedPlace& each : *all)
                each.spacing *= by;
    }
};

/// `count`: of all samples, shared out among the pieces; 0: what they need. Throws base::Cancelled.
PieceSpacings pieceSpacings(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                            const InnerPlaces& inside, std::size_t count, const base::Progress& progress = {});

/// Most samples of pieces of these spacings, which may ask for more at one another.
double mostSamplesOf(const FaceTopology& topology, std::span<const double> spacings);

} // namespace mesh
