// Any-hit rays, for shadows and ambient occlusion (raycast/README 4.3 and 4.4): does anything stand in their way?
#pragma once

#include "core/raycast/light_points.h"

namespace raycast {

/// 1 for rays that hit the model nearer than `reach`, 0 for others. What clip planes cut away blocks nothing. In
/// parallel; the same bits at any thread count.
void findBlocked(const LightScene& scene, std::span<const base::Rayf> rays, float reach, std::span<std::uint8_t> out);

/// Which directions of directions.h the points take.
struct RayPatterns {
    std::vector<std::uint8_t> pattern; ///< of each point
    int factor = 1;                    ///< times the rays of the lighting
};

/// For samples [begin, begin + count). Sixteen neighbours in an image share all directions; of points that are no
/// neighbours, as smooth_edges.h asks about, eight do, and each takes twice as many.
RayPatterns rayPatternsOf(const SeenSamples& seen, std::size_t begin, std::size_t count);

/// Whether rays to lamps and sky start at a point. Not on glass and metal, which show them along paths of light.
bool asksForLight(const LightScene& scene, const LightPoint& point);

/// The part of each lamp that the points see: out[lamp * points.size() + i]. Lamps below a point's horizon cost no ray
/// and count as seen.
void findShadows(const LightScene& scene, std::span<const LightPoint> points, const RayPatterns& patterns,
                 std::span<float> out, LightCounts& counts);

/// The part of the sky above the points that is open, weighted with the cosine: the ground, and surface within
/// `occlusionReach`, block it.
void findOcclusion(const LightScene& scene, std::span<const LightPoint> points, const RayPatterns& patterns,
                   std::span<float> out, LightCounts& counts);

} // namespace raycast
