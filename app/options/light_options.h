// Options of `render` that say how cast rays are lit: material, lamps, shadows, ground. Loops over the tables of
// core/raycast.
#pragma once

#include "app/subcommands/subcommand.h"
#include "core/render/picture.h"

namespace app {

struct LightOptions {
    std::string material = "matcap", lights;
    bool shadows = false, ground = false, smooth = false;
};

std::shared_ptr<LightOptions> addLightOptions(OptionSet command);

/// Sets the light of `out`, whose rayCast and style are set already; `occlusion`: --ao was given. Throws UsageError for
/// what does not go together.
void applyLights(const LightOptions& options, bool occlusion, render::PictureOptions& out);

} // namespace app
