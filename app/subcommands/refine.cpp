// pointclay refine: the way back from a reduced model, dense and even samples on the surface that it defines.
#include "core/reduce/refine.h"
#include "app/open_model.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/reduce_report.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/commands/commands.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

namespace {

struct RefineArguments {
    std::string model, out, report, against;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
};

/// The refined model beside the one that was reduced: its points to the new surface, as `reduce` tells it.
reduce::Report compared(const RefineArguments& options, const surface::Surface& refined, const base::Vec3d& origin,
                        const base::Progress& progress, Console& console) {
    session::Document document;
    session::Context context{document, {}, process::part(progress, 0, 0.5), {}, 0, {}, nullptr};
    openModel(context, options.against, options.surface->parameters(), console);
    const surface::Surface model = shifted(document.surface(), document.provenance().origin - origin);
    return reduce::verifyAgainst(model, refined, process::part(progress, 0.5, 1));
}

void runRefine(const RefineArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}, {"--report", options.report}});
    requireModelName(options.out);
    nlohmann::json wish = parametersOf(options.wish);
    wish["op"] = "refine";
    const auto spacing = session::complete(wish).at("spacing").get<float>();
    session::Document document;
    const base::Progress progress = console.progress();
    const base::Progress opening = process::part(progress, 0, 0.1);
    session::Context context{document, {}, opening, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    reduce::Refined result = reduce::refine(document.surface(), spacing, process::part(progress, 0.1, 0.7));
    const reduce::Report report = options.against.empty()
                                      ? result.report
                                      : compared(options, result.surface, document.provenance().origin,
                                                 process::part(progress, 0.7, 0.95), console);
    document.commit(std::move(result.surface), "Refine");
    io::write(options.out, document.fileModel(), process::part(progress, 0.95, 1));
    if (!options.report.empty())
        io::writeFile(options.report, reduceReportJson(report).dump(2) + "\n");
    console.clear();
    std::cout << reduce::refinedSummaryOf(report, options.against.empty() ? "the surface before" : options.against)
              << '\n';
}

} // namespace

Action addRefine(OptionSet command) {
    auto options = std::make_shared<RefineArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("-o,--output", options->out, "model to write: " + writableExtensions()).typeName("OUT").required();
    for (const session::CommandParameter& p : session::command("refine").parameters)
        addParameter(command, "refine", p, helpOf(p), options->wish).required();
    command
        .add("--to", options->against,
             "the model that was reduced: how near the refined one is to its points is told instead of how near "
             "it is to the reduced surface")
        .typeName("MODEL");
    command
        .add("--report", options->report,
             "JSON file to write that to, lengths in model units, with the keys of `reduce`")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runRefine(*options, console); };
}

} // namespace app
