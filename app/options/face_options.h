// The option group "Faces": what becomes of a file's faces, the same for every subcommand that reads a model.
#pragma once

#include "app/options/command_options.h"

namespace app {

/// REQUIRES: `given` outlives the command. `model`: the option that they belong to, where it is not required.
void addFaceOptions(CLI::App& command, GivenParameters& given, CLI::Option* model = nullptr);

} // namespace app
