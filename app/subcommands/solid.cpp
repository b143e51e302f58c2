// pointclay solid: two models put together as solids, by the session's own command.
#include "app/open_model.h"
#include "app/options/model_command.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/usage_error.h"
#include "core/io/safe_file.h"
#include "core/mesh/extent/extent.h"

#include <nlohmann/json.hpp>

namespace app {

namespace {

struct SolidArguments : ModelCommand {
    std::string other, report;
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

void runSolid(const SolidArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}, {"--report", options.report}});
    if (has(options.wish, "fillet") && has(options.wish, "chamfer"))
        throw UsageError("--fillet and --chamfer exclude each other");
    constexpr std::string_view sample = "sample:";
    const bool made = options.other.starts_with(sample);
    const std::string what = made ? options.other.substr(sample.size()) : options.other;
    runModelCommand(options, "solid", {{made ? "sample" : "path", what}, {"seams", !options.report.empty()}}, console,
                    [&](const session::Context& context) {
                        if (!options.report.empty())
                            io::writeFile(options.report, reportOf(context, context.progress).dump(2) + "\n");
                    });
}

bool isOwn(std::string_view id) {
    return id == "path" || id == "sample" || id == "model" || id == "hash" || id == "sources" || id == "operation" ||
           id == "seams" || id == "creases"; // of opening
}

} // namespace

Action addSolid(OptionSet command) {
    auto options = std::make_shared<SolidArguments>();
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
    command
        .add("--report", options->report,
             "JSON file to write what came of it to: volume (null where the result is open), seam_length in "
             "model units, seams (pieces of curves between corners), corners, open (true or false)")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runSolid(*options, console); };
}

} // namespace app
