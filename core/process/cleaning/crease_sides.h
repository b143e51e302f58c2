// On which side of a crease points stand: at a sharp edge a plane through all neighbours lies across it. The plane that
// most of them agree with, up to their noise, is one of the faces; where normals of neighbours are then of two kinds
// there is a crease (process/README 11.3).
#pragma once

#include "core/process/neighbours/knn.h"

namespace process {

struct CreaseSides {
    std::vector<base::Vec3f> normals; ///< of the own face; signs as those given
    std::vector<float> least; ///< cosine of two normals below which a neighbour is beyond a crease; -1 without one

    bool together(std::size_t i, std::size_t j, bool oriented) const {
        const float cosine = dot(normals[i], normals[j]);
        return (oriented ? cosine : std::abs(cosine)) > least[i];
    }
};

/// One of each for every position; so are `normals` and `noise`, standard deviations across the surface. In parallel,
/// the same bits at any thread count.
CreaseSides creaseSides(const Cloud& cloud, std::span<const base::Vec3f> normals, bool oriented,
                        std::span<const float> noise, const base::Progress& progress = {});

} // namespace process
