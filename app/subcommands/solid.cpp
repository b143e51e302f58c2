// pointclay solid: two models put together as solids, by the session's own command.
#include "app/open_model.h"
#include "app/options/command_options.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct Options {
    std::string model, other, out;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
};

void run(const Options& options, Console& console) {
    constexpr std::string_view sample = "sample:";
    nlohmann::json command = parametersOf(options.wish);
    command["op"] = "solid";
    if (options.other.starts_with(sample))
        command["sample"] = options.other.substr(sample.size());
    else
        command["path"] = options.other;
    session::Document document;
    session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    session::run(context, command);
    session::run(context, {{"op", "save"}, {"path", options.out}});
    console.tell(context.messages);
}

bool isOwn(std::string_view id) {
    return id == "path" || id == "sample" || id == "hash" || id == "operation" || id == "creases"; // of opening
}

} // namespace

Action addSolid(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("A", options->model, modelHelp)->required();
    command.add_option("B", options->other, std::string("the other one: ") + modelHelp)->required();
    command.add_option("-o,--output", options->out, "model to write; .ply keeps everything")
        ->type_name("OUT")
        ->required();
    for (const session::CommandParameter& p : session::command("solid").parameters) {
        if (p.id == std::string_view("operation")) {
            auto given = [options](const std::string& value) { options->wish.emplace_back("operation", value); };
            command.add_option_function<std::string>("--op", given, helpOf(p))
                ->check(CLI::IsMember({"union", "difference", "intersection"}))
                ->required();
        } else if (!isOwn(p.id)) {
            addParameter(command, "solid", p, helpOf(p), options->wish);
        }
    }
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
