// What surfels say about rims (process/README 3): off-centre values, angular gaps, the rim that they may lie at.
#pragma once

#include "core/surface/curves/boundary.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace process {

/// A surfel, as its place in tree order: `key` is that of its block times the capacity of one, plus its slot.
struct RimPlace {
    std::uint32_t key = 0;
    base::Vec3f position;
};

constexpr std::uint32_t rimKey(std::uint32_t block, int slot) {
    return block * static_cast<std::uint32_t>(surfel::blockCapacity) + static_cast<std::uint32_t>(slot);
}

struct RimSample {
    RimPlace at;
    float offCentre = 0;                                 ///< at the foot, in units of h
    float gap = std::numeric_limits<float>::quiet_NaN(); ///< the largest angle without a neighbour; NaN: no foot
    base::Vec3f foot, normal;
};

/// For each place. Throws base::Cancelled.
std::vector<RimSample> lookAt(const surface::Surface& surface, std::span<const RimPlace> places,
                              const base::Progress& progress);

/// The rim for the loosest limit that a sample lies beside; NotConverged where there is none. `loose`: the surface
/// with that limit.
surface::BoundarySearch rimBeside(const surface::Surface& loose, const RimSample& sample);

/// The surface with the loosest limit.
surface::Surface loosened(const surface::Surface& surface);

constexpr float loosestLimit = 0.45f;

} // namespace process
