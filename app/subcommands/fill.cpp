// pointclay fill: the holes of a model closed, by the session's own command.
#include "app/options/model_command.h"

#include <nlohmann/json.hpp>

namespace app {

Action addFill(OptionSet command) {
    auto options = std::make_shared<ModelCommand>();
    addModelAndOutput(command, *options);
    for (const session::CommandParameter& p : session::command("fill").parameters)
        addParameter(command, "fill", p, helpOf(p), options->wish);
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runModelCommand(*options, "fill", nlohmann::json::object(), console); };
}

} // namespace app
