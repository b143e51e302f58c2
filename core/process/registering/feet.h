// Some points of models and their feet on the other models' surfaces: what registration compares. Inside this folder.
#pragma once

#include "core/process/registering/align.h"

#include <vector>

namespace process {

/// Some surfels of a model, evenly chosen, in its own coordinates.
struct AskedPoints {
    std::vector<base::Vec3d> position, normal;
    bool oriented = false;
};

AskedPoints askedPoints(const surface::Surface& surface, std::size_t count);

/// Which of the points, moved by `there` into the model's own coordinates, have a surfel of it within reach: others
/// have no foot on it. In parallel.
std::vector<std::uint32_t> pointsNear(const surface::Surface& on, const AskedPoints& asked, const Rigid& there,
                                      float reach);

/// A point of one model with its foot on another one, both in the coordinates of all.
struct FootPair {
    std::uint32_t from, to, point;
    base::Vec3d x, n; ///< the point, and the foot's unit normal
    double off;       ///< along n
    double distance;  ///< to the foot
    double alike;     ///< cosine between the point's normal and the foot's; of unoriented ones without sign
};

/// Feet of all points on all other models that are no farther than `reach` and face the same way within 60 degrees.
std::vector<FootPair> footPairs(const std::vector<Placed>& models, const std::vector<AskedPoints>& asked, double reach);

} // namespace process
