// Options of `render` that say how the picture looks, whatever it shows from wherever: shading and its scale,
// background. Loops over the tables of ui/render.
#pragma once

#include "app/subcommand.h"
#include "core/session/document.h"
#include "ui/render/picture.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

struct LookOptions {
    std::string shading = "matcap", range, reference, backdrop = "studio";
    bool transparent = false;
};

std::shared_ptr<LookOptions> addLookOptions(CLI::App& command);

/// Sets everything of `out` that the options say; opens the reference with the same surface options as `document`'s
/// model, and in its coordinates. Throws base::Error, UsageError.
void applyLook(const LookOptions& options, const session::Document& document, const nlohmann::json& surface,
               Console& console, render::PictureOptions& out);

} // namespace app
