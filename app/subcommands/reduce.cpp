// pointclay reduce: a model with fewer points on the same surface, written to a file, and how near it is.
#include "app/open_model.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/reduce_report.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/commands/reduce_wish.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

namespace {

constexpr const char* wishes[] = {"count", "ratio", "error"};

struct ReduceArguments {
    std::string model, out, report;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
};

void runReduce(const ReduceArguments& options, OptionSet command, Console& console) {
    requireOutputs({{"-o", options.out}, {"--report", options.report}});
    requireModelName(options.out);
    int asked = 0;
    for (const char* wish : wishes)
        asked += command.has(std::string("--") + wish);
    if (asked != 1)
        throw UsageError("reduce needs one of --count, --ratio and --error, and no other");
    nlohmann::json wish = parametersOf(options.wish);
    wish["op"] = "reduce";
    const reduce::Wish what = session::reduceWish(session::complete(wish));
    session::Document document;
    const base::Progress progress = console.progress();
    const base::Progress opening = process::part(progress, 0, 0.2), reducing = process::part(progress, 0.2, 0.95);
    session::Context context{document, {}, opening, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    reduce::Reduced result = reduce::reduceBy(document.surface(), what, reducing);
    document.commit(std::move(result.surface), "Reduce");
    io::write(options.out, document.fileModel(), process::part(progress, 0.95, 1));
    if (!options.report.empty())
        io::writeFile(options.report, reduceReportJson(result.report).dump(2) + "\n");
    console.clear();
    std::cout << reduce::summaryOf(result.report) << '\n';
}

} // namespace

Action addReduce(OptionSet command) {
    auto options = std::make_shared<ReduceArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("-o,--output", options->out, "model to write: " + writableExtensions()).typeName("OUT").required();
    for (const session::CommandParameter& p : session::command("reduce").parameters)
        addParameter(command, "reduce", p, helpOf(p), options->wish);
    command
        .add("--report", options->report,
             "JSON file to write what was verified to, lengths in model units: count, rms, p999 and max of the "
             "model's points to the reduced surface, normals_deg between the two surfaces (rms), least_supports "
             "over a point, holes (points that miss the reduced surface alone), shapes")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options, command](Console& console) { runReduce(*options, command, console); };
}

} // namespace app
