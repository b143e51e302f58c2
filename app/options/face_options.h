// The option group "Faces": what becomes of a file's faces, the same for every subcommand that reads a model.
#pragma once

#include "app/options/command_options.h"

#include <optional>

namespace app {

/// REQUIRES: `given` outlives the command. `model`: the option that they belong to, where it is not required.
void addFaceOptions(OptionSet command, GivenParameters& given, std::optional<Option> model = {});

} // namespace app
