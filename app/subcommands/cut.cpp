// pointclay cut: a model cut by a plane, by the session's own command.
#include "app/options/model_command.h"
#include "app/options/view_options.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct CutArguments : ModelCommand {
    bool cap = false;
};

} // namespace

Action addCut(OptionSet command) {
    auto options = std::make_shared<CutArguments>();
    addModelAndOutput(command, *options);
    for (const session::CommandParameter& p : session::command("cut").parameters) {
        const std::string_view id = p.id;
        if (id == "cap" || id == "creases") // which is of opening
            continue;
        Option option = addParameter(command, "cut", p, helpOf(p), options->wish);
        if (id == "plane")
            option.check({planeFault}).required();
    }
    command.addFlag("--cap", options->cap, "close what was cut, as dense as the model is beside it");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runModelCommand(*options, "cut", {{"cap", options->cap}}, console); };
}

} // namespace app
