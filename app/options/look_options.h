// Options of `render` that say how the picture looks, whatever it shows from wherever: shading and its scale,
// background. Loops over the tables of core/render.
#pragma once

#include "app/options/light_options.h"
#include "core/render/picture.h"
#include "core/session/document.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

struct LookOptions {
    std::string shading, attribute, range, reference, backdrop = "studio",
                                                      effects; ///< no `shading`: what suits the model
    bool occlusion = false, grid = false;
    bool transparent = false;
    render::Annotated annotated = render::Legend;
    std::shared_ptr<LightOptions> light;
};

std::shared_ptr<LookOptions> addLookOptions(OptionSet command);

/// Sets everything of `out` that the options say, whose rayCast is set already; opens the reference with the same
/// surface options as `document`'s model, and in its coordinates. Throws base::Error, UsageError. `up`: of the view,
/// for the grid.
void applyLook(const LookOptions& options, const session::Document& document, const nlohmann::json& surface,
               const base::Vec3d& up, Console& console, render::PictureOptions& out);

} // namespace app
