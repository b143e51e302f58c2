// pointclay cut: a model cut by a plane, by the session's own command.
#include "app/options/model_command.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct Options : ModelCommand {
    bool cap = false;
};

} // namespace

Action addCut(OptionSet command) {
    auto options = std::make_shared<Options>();
    addModelAndOutput(command, *options);
    for (const session::CommandParameter& p : session::command("cut").parameters)
        if (p.id != std::string_view("cap") && p.id != std::string_view("creases")) // which is of opening
            addParameter(command, "cut", p, helpOf(p), options->wish).required(p.id == std::string_view("plane"));
    command.addFlag("--cap", options->cap, "close what was cut, as dense as the model is beside it");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runModelCommand(*options, "cut", {{"cap", options->cap}}, console); };
}

} // namespace app
