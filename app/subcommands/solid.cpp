// pointclay solid: two models put together as solids, by the session's own command.
#include "app/open_model.h"
#include "app/options/command_options.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/io/safe_file.h"
#include "core/mesh/extent/extent.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct Options {
    std::string model, other, out, report;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
};

/// No volume where the result is open.
nlohmann::ordered_json reportOf(const session::Context& context, const base::Progress& progress) {
    const mesh::Extent extent = mesh::extentOf(context.document.surface(), 0, progress);
    return {{"volume", extent.closed ? nlohmann::ordered_json(extent.volume) : nlohmann::ordered_json()},
            {"seam_length", context.figures.at("seam_length")},
            {"seams", static_cast<std::size_t>(context.figures.at("seams"))},
            {"corners", static_cast<std::size_t>(context.figures.at("corners"))},
            {"open", !extent.closed}};
}

void run(const Options& options, Console& console) {
    constexpr std::string_view sample = "sample:";
    nlohmann::json command = parametersOf(options.wish);
    command["op"] = "solid";
    command["seams"] = !options.report.empty();
    if (options.other.starts_with(sample))
        command["sample"] = options.other.substr(sample.size());
    else
        command["path"] = options.other;
    session::Document document;
    session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    session::run(context, command);
    session::run(context, {{"op", "save"}, {"path", options.out}});
    if (!options.report.empty())
        io::writeFile(options.report, reportOf(context, console.progress()).dump(2) + "\n");
    console.tell(context.messages);
}

bool isOwn(std::string_view id) {
    return id == "path" || id == "sample" || id == "hash" || id == "operation" || id == "seams" ||
           id == "creases"; // of opening
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
    command
        .add_option("--report", options->report,
                    "JSON file to write what came of it to: volume (null where the result is open), seam_length in "
                    "model units, seams (pieces of curves between corners), corners, open (true or false)")
        ->type_name("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
