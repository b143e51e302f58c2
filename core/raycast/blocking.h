// Rays that ask one thing: does anything stand in their way? Shadows and ambient occlusion are made of them.
#pragma once

#include "core/raycast/places.h"

namespace raycast {

/// 1 for rays that meet the model nearer than `reach`, 0 for others. Where planes cut the model, what they cut away
/// stands in nobody's way. In parallel; the same bits at any thread count.
void findBlocked(const LightScene& scene, std::span<const base::Rayf> rays, float reach, std::span<std::uint8_t> out);

/// Which directions places look into (directions.h).
struct Looks {
    std::vector<std::uint8_t> pattern; ///< of each place
    int factor = 1;                    ///< times the rays of the lighting
};

/// For samples [begin, begin + count): sixteen neighbours in an image share all directions; of places that are no
/// neighbours eight do, as smooth_edges.h asks for them, and take twice as many each.
Looks looksOf(const SeenSamples& seen, std::size_t begin, std::size_t count);

/// Whether lamps and sky are asked for at a place: glass and metal show them in the paths of light.
bool asksForLight(const LightScene& scene, const Place& place);

/// The part of each lamp that the places see: out[lamp * places.size() + i]. Lamps below the place's horizon are not
/// asked for, and count as seen.
void findShadows(const LightScene& scene, std::span<const Place> places, const Looks& looks, std::span<float> out,
                 LightCounts& counts);

/// The part of the sky above the places that is open, weighted with the cosine: surface within `occlusionReach` and
/// the ground hold it off.
void findOcclusion(const LightScene& scene, std::span<const Place> places, const Looks& looks, std::span<float> out,
                   LightCounts& counts);

} // namespace raycast
