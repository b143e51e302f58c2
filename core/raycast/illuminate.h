// The light of a cast picture (raycast/README 4): a pass over what primary rays hit, whoever cast them, with lamps,
// shadows, ambient occlusion, glass and metal.
//
//     LightScene         model, lamps, ground          light_points.h, environment.h, light_rigs.h, material_table.h
//     findLightPoints    from samples to the surface   light_points.h
//     findShadows, findOcclusion                       blocking.h, with the directions of directions.h
//     edgeAwareFilter    neighbours share their rays   edge_aware_filter.h
//     followLight        glass and metal               light_paths.h, optics.h
#pragma once

#include "core/raycast/light_points.h"

namespace raycast {

/// Light of one sample.
struct Lit {
    base::Vec3f colour; ///< linear light; unused by the matcap, which has its own
    float shade = 1;    ///< part of the light that shadow and occlusion leave, on the matcap and on the ground
    Seen seen = Seen::Nothing;
};

/// out[i] for samples[i]. In parallel; the same bits at any thread count. Throws base::Cancelled.
void illuminate(const LightScene& scene, const SeenSamples& seen, std::span<Lit> out, LightCounts& counts,
                const base::Progress& progress = {});

} // namespace raycast
