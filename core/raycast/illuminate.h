// The light of a cast picture: a pass over what primary rays met, whoever found it, that knows lamps, shadows, ambient
// occlusion, glass and metal (alg. 4.2).
//
//     LightScene    model, lamps, ground           places.h, environment.h, light_rigs.h, material_table.h
//     findPlaces    from samples onto the surface   places.h
//     findShadows, findOcclusion                    blocking.h, with the directions of directions.h
//     evenOut       neighbours share their rays     even_out.h
//     followLight   glass and metal                 light_paths.h, optics.h
#pragma once

#include "core/raycast/places.h"

namespace raycast {

/// Light of one sample.
struct Lit {
    base::Vec3f colour; ///< linear light; of the matcap, which has its own, unused
    float shade = 1;    ///< what shadow and occlusion leave of light: of the matcap, and of what the ground hides
    Seen seen = Seen::Nothing;
};

/// out[i] for samples[i]. In parallel; the same bits at any thread count. Throws base::Cancelled.
void illuminate(const LightScene& scene, const SeenSamples& seen, std::span<Lit> out, LightCounts& counts,
                const base::Progress& progress = {});

} // namespace raycast
