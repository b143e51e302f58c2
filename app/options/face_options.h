// The option groups "Reading" and "Faces": what a file does not tell itself, and what becomes of its faces, the same
// for every subcommand that reads a model.
#pragma once

#include "app/options/command_options.h"

#include <optional>

namespace app {

/// REQUIRES: `given` outlives the command. `model`: the option that they belong to, where it is not required. Both
/// groups.
void addFaceOptions(OptionSet command, GivenParameters& given, std::optional<Option> model = {});

} // namespace app
