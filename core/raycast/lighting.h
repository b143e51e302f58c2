// How a cast picture is lit: a plain value that the command line and the window set.
#pragma once

#include "core/raycast/light_rigs.h"
#include "core/raycast/material_table.h"

#include <vector>

namespace raycast {

struct Lighting {
    Material material = Material::Matcap;
    LightRig rig = LightRig::Studio;
    /// Own lamps in these directions (towards them, model coordinates) instead of the rig's.
    std::vector<base::Vec3f> directions;
    bool shadows = false;
    bool occlusion = false; ///< ambient occlusion: nearby surface blocks light of the room
    bool ground = false;    ///< shadows and occlusion fall on the ground below the model too
    /// Rays of each point to each soft lamp, and around it. Sixteen neighbours share what theirs found.
    int shadowRays = 3, occlusionRays = 6;
    float occlusionReach = 0.25f; ///< how far surface blocks it, in diagonals of the model's bounds
    int bounces = 10;             ///< of light in glass and between mirrors

    bool operator==(const Lighting&) const = default;
    /// Whether there is anything to do beyond shading what primary rays met.
    bool wanted() const { return material != Material::Matcap || shadows || occlusion; }
};

struct LightCounts {
    std::size_t shadowRays = 0, occlusionRays = 0;
    std::size_t pathRays = 0; ///< reflected and refracted

    LightCounts& operator+=(const LightCounts& more) {
        shadowRays += more.shadowRays, occlusionRays += more.occlusionRays, pathRays += more.pathRays;
        return *this;
    }
};

} // namespace raycast
