// The option groups "Surface" and "Faces", the same for every subcommand: loops over the parameters of the commands
// `surface` and `open`.
#pragma once

#include "app/options/command_options.h"

#include <memory>

namespace app {

struct SurfaceOptions {
    GivenParameters given;
    std::string precision = "float";

    /// As parameters of `open` and `new`.
    nlohmann::json parameters() const;
    bool inDouble() const { return precision == "double"; }
};

/// `withPrecision`: where the subcommand can answer in float64, too.
std::shared_ptr<SurfaceOptions> addSurfaceOptions(OptionSet command, bool withPrecision);

} // namespace app
