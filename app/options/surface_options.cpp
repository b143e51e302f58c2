#include "app/options/surface_options.h"
#include "app/options/option_checks.h"

#include "app/options/face_options.h"
#include "core/session/surface_options.h"

#include <nlohmann/json.hpp>

namespace app {

using session::CommandParameter;

nlohmann::json SurfaceOptions::parameters() const {
    return parametersOf(given);
}

/// What holds where nobody has said otherwise; "" where that is nothing.
static std::string fallbackOf(const CommandParameter& p) {
    const surface::DefinitionOption& option = surface::definitionOption(p.id);
    return option.range.orZero ? "" : surface::textOf(option, {});
}

/// Where models open otherwise (mesh/README 8.3).
static std::string exceptionOf(const CommandParameter& p) {
    return p.id == std::string_view("one-sheet") ? "; off for faces sampled so finely that no wall is thinner than 2.5 "
                                                   "spacings, but for edges of less than 60 degrees"
                                                 : "";
}

std::shared_ptr<SurfaceOptions> addSurfaceOptions(OptionSet command, bool withPrecision) {
    auto options = std::make_shared<SurfaceOptions>();
    std::map<std::string, Option> added;
    for (const CommandParameter& p : session::surfaceParameters()) {
        const std::string fallback = fallbackOf(p);
        const std::string help =
            helpOf(p) + (fallback.empty() ? "" : " [" + fallback + ", or what the file says" + exceptionOf(p) + "]");
        Option option = addParameter(command, "surface", p, help, options->given);
        option.group("Surface");
        added.emplace(p.id, option);
        if (const char* other = surface::definitionOption(p.id).excludes)
            option.excludes(added.at(other));
    }
    if (withPrecision)
        command.add("--precision", options->precision, "arithmetic, and digits written: 9 for float, 17 for double")
            .group("Surface")
            .check(oneOf({"float", "double"}))
            .showDefault();
    addFaceOptions(command, options->given);
    return options;
}

} // namespace app
