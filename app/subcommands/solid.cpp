// pointclay solid: two models put together as solids, by the session's own command.
#include "app/open_model.h"
#include "app/options/model_command.h"
#include "app/options/option_checks.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct Options : ModelCommand {
    std::string other;
};

void run(const Options& options, Console& console) {
    constexpr std::string_view sample = "sample:";
    const bool made = options.other.starts_with(sample);
    const std::string what = made ? options.other.substr(sample.size()) : options.other;
    runModelCommand(options, "solid", {{made ? "sample" : "path", what}}, console);
}

bool isOwn(std::string_view id) {
    return id == "path" || id == "sample" || id == "hash" || id == "operation" || id == "creases"; // of opening
}

} // namespace

Action addSolid(OptionSet command) {
    auto options = std::make_shared<Options>();
    addModelAndOutput(command, *options, "A");
    command.add("B", options->other, std::string("the other one: ") + modelHelp).required();
    for (const session::CommandParameter& p : session::command("solid").parameters) {
        if (p.id == std::string_view("operation")) {
            auto given = [options](const std::string& value) { options->wish.emplace_back("operation", value); };
            command.addTo("--op", given, helpOf(p)).check(oneOf({"union", "difference", "intersection"})).required();
        } else if (!isOwn(p.id)) {
            addParameter(command, "solid", p, helpOf(p), options->wish);
        }
    }
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
