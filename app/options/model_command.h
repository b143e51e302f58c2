// Subcommands that are one command of a session: a model is opened, the command changes it, and it is saved.
#pragma once

#include "app/options/command_options.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"

#include <functional>

namespace app {

struct ModelCommand {
    std::string model, out;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
};

/// Adds the model, called `name` in help, and -o.
void addModelAndOutput(OptionSet command, ModelCommand& options, const char* name = "MODEL");

/// A subcommand that is a command of the session and nothing else: all of its parameters but `creases`, which is of
/// opening, as options, those that it needs required.
Action addModelCommand(OptionSet command, const char* op);

/// `given` are parameters beside those wished for. Once the model is saved, does what comes `then`, with the
/// progress of that, and tells what the commands tell.
void runModelCommand(const ModelCommand& options, const char* op, const nlohmann::json& given, Console& console,
                     const std::function<void(const session::Context&)>& then = {});

} // namespace app
