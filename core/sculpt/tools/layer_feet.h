// Where surfels under a layer have their feet on the version that the stroke began on.
//
//     started[i] = place that lies near that version, by what is known of a neighbour
//     feet = layerFeet(first, started, places)
//
// A Newton step from there, q = x - f g / |g|^2, and where the place then lies beside q's normal N a next one from
// x' = q + (1 - N N^T)(p - q), while that brings it nearer. A projection only where f is no small part of the support:
// what a stroke has not moved lies on its version but for noise, and what it has raised is beside others whose ways up
// are known. From above a thick layer a projection takes a hundred times as long, and may land on another side.
//
// Places without a foot say so. In parallel; the same bits at any thread count.
#pragma once

#include "core/surface/surface.h"

#include <optional>
#include <span>
#include <vector>

namespace sculpt {

struct LayerFoot {
    base::Vec3f foot, normal; ///< its unit gradient
    base::Mat3f bend;         ///< the gradient of the model's normal there, turned as `normal` is
};

/// REQUIRES: as many `started` as `places`; where a step from `started` does not do, the foot of the place counts.
std::vector<std::optional<LayerFoot>> layerFeet(const surface::Surface& first, std::span<const base::Vec3f> started,
                                                std::span<const base::Vec3f> places);

/// The foot of one place, by projection.
std::optional<base::Vec3f> layerFoot(const surface::Surface& first, const base::Vec3f& place);

} // namespace sculpt
