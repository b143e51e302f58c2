// pointclay resample: the same surface with its points spaced anew, by the session's own command.
#include "app/open_model.h"
#include "app/options/batch_options.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/process/estimation/spacing_sample.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace app {

namespace {

struct ResampleArguments {
    std::string model, out;
    double spacing = 0, tolerance = 0;
    std::size_t count = 0;
    bool unfitted = false;
    BatchOptions batch;
    std::shared_ptr<SurfaceOptions> surface;
};

nlohmann::ordered_json resampled(const ResampleArguments& options, const BatchJob& job, Console& console) {
    requireOutputs({{"-o", job.out}});
    requireModelName(job.out);
    session::Document document;
    session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, job.in, options.surface->parameters(), console);
    nlohmann::json command{{"op", "resample"}};
    if (options.spacing > 0)
        command["spacing"] = options.spacing;
    if (options.count > 0)
        command["count"] = options.count;
    if (options.tolerance > 0)
        command["tolerance"] = options.tolerance;
    if (options.unfitted)
        command["fit"] = false;
    const std::size_t before = document.surface().tree().size();
    session::run(context, command);
    console.tell(context.messages);
    session::run(context, {{"op", "save"}, {"path", job.out}});
    const tree::SurfelTree& tree = document.surface().tree();
    std::ostringstream text;
    const float spacing = process::typicalSpacing(tree);
    text << before << " points became " << tree.size();
    if (spacing > 0) // a handful has none
        text << ", spaced by " << spacing << " in the middle";
    console.tell(text.str() + ".");
    return {{"before", before}, {"surfels", tree.size()}, {"spacing", spacing}};
}

void runResample(const ResampleArguments& options, OptionSet set, Console& console) {
    if ((options.spacing > 0) + (options.tolerance > 0) + (options.count > 0) != 1)
        throw UsageError("give one of --spacing, --count and --adaptive");
    if (options.batch.wanted() && options.out.empty())
        return runBatch("resample", set, options.batch, {options.model}, {"ply", isWritableModel, true}, console,
                        [&](const BatchJob& job) { return resampled(options, job, console); });
    requireOneOutput(options.batch, options.out);
    resampled(options, {options.model, options.out}, console);
}

} // namespace

Action addResample(OptionSet command) {
    auto options = std::make_shared<ResampleArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("-o,--output", options->out, "model to write; .ply keeps everything").typeName("OUT");
    Option spacing =
        command.add("--spacing", options->spacing, "distance between neighbouring points to reach, in model units")
            .typeName("S")
            .check(above(0));
    Option count = command.add("--count", options->count, "number of points to reach, within a few percent")
                       .typeName("N")
                       .check(between(4, 1e9));
    command
        .add("--adaptive", options->tolerance,
             "let the distance follow the curvature, so that facets as wide would stay about an eighth of this close "
             "to the surface; from half to twice the present median, in model units")
        .typeName("TOLERANCE")
        .check(above(0))
        .excludes(spacing)
        .excludes(count);
    spacing.excludes(count);
    command.addFlag("--no-fit", options->unfitted,
                    "leave out the last step, which raises and tilts the new points until their surface is the one "
                    "before: details of a few spacings then wear off");
    addBatchOptions(command, options->batch);
    options->surface = addSurfaceOptions(command, false);
    return [options, command](Console& console) { runResample(*options, command, console); };
}

} // namespace app
