// pointclay fill: the holes of a model closed, by the session's own command.
#include "app/open_model.h"
#include "app/options/command_options.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct Options {
    std::string model, out;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
};

void run(const Options& options, Console& console) {
    nlohmann::json command = parametersOf(options.wish);
    command["op"] = "fill";
    session::Document document;
    session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    session::run(context, command);
    session::run(context, {{"op", "save"}, {"path", options.out}});
    console.tell(context.messages);
}

} // namespace

Action addFill(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("MODEL", options->model, modelHelp)->required();
    command.add_option("-o,--output", options->out, "model to write; .ply keeps everything")
        ->type_name("OUT")
        ->required();
    for (const session::CommandParameter& p : session::command("fill").parameters)
        addParameter(command, "fill", p, helpOf(p), options->wish);
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
