// pointclay clean: what is not the model taken out of a scan, by the session's own command, with its numbers.
#include "app/open_model.h"
#include "app/options/batch_options.h"
#include "app/options/memory_option.h"
#include "app/options/number_list.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "app/tiled_clean.h"
#include "app/writable_models.h"
#include "core/io/safe_file.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace app {

using nlohmann::ordered_json;

namespace {

struct CleanArguments {
    std::string in, out, report, viewpoint, memory;
    bool duplicates = false, mixed = false, dryRun = false;
    BatchOptions batch;
    GivenParameters steps;
    std::shared_ptr<SurfaceOptions> surface;
};

std::string viewpointFault(const std::string& text) {
    double v[3];
    return parseNumbers(text, ',', v) ? "" : "'" + text + "' is not a place; write x,y,z";
}

nlohmann::json commandOf(const CleanArguments& options) {
    nlohmann::json out = parametersOf(options.steps);
    out["op"] = "clean";
    out["duplicates"] = options.duplicates;
    out["mixed"] = options.mixed;
    if (!options.viewpoint.empty()) {
        double v[3];
        parseNumbers(options.viewpoint, ',', v);
        out["viewpoint"] = {v[0], v[1], v[2]};
    }
    return out;
}

/// Of each step that was asked for what it counted and measured.
ordered_json reportOf(const nlohmann::json& command, const session::Context& context, std::size_t before) {
    const session::Document& document = context.document;
    const auto figure = [&](const char* name) { return context.figures.at(name); };
    const auto count = [&](const char* name) { return static_cast<std::size_t>(figure(name)); };
    ordered_json out;
    out["read"] = before + document.provenance().merged + document.provenance().dropped;
    out["dropped"] = document.provenance().dropped;
    out["merged"] = document.provenance().merged;
    if (command.at("duplicates").get<bool>())
        out["duplicates"] = {{"removed", count("duplicates")}};
    if (command.at("mixed").get<bool>())
        out["mixed"] = {{"removed", count("mixed")}, {"viewpoints", count("viewpoints")}};
    if (command.contains("outliers")) {
        const auto methods = command.at("outliers").get<std::string>();
        out["outliers"] = {{"method", methods}, {"removed", count("outliers")}};
        std::istringstream in(methods);
        for (std::string method; std::getline(in, method, ',') && method != methods;)
            out["outliers"]["by"][method] = count(("outliers_" + method).c_str());
    }
    if (command.contains("denoise"))
        out["denoise"] = {
            {"sigma", figure("sigma")}, {"moved_rms", figure("moved_rms")}, {"moved_max", figure("moved_max")}};
    if (command.contains("thin"))
        out["thin"] = {{"spacing", command.at("thin")}, {"removed", count("thinned")}};
    if (command.contains("normals"))
        out["normals"] = {{"method", command.at("normals")}, {"turned_deg", figure("turned_deg")}};
    if (command.contains("orient"))
        out["orient"] = {
            {"method", command.at("orient")}, {"flipped", count("flipped")}, {"doubtful", figure("doubtful")}};
    out["surfels"] = document.surface().tree().size();
    return out;
}

/// One file; its report.
ordered_json cleaned(const CleanArguments& options, const BatchJob& job, Console& console) {
    if (!options.dryRun)
        requireModelName(job.out);
    if (!options.memory.empty() && needsTiles(job.in, bytesOf(options.memory))) {
        std::vector<std::string> messages;
        ordered_json report = cleanInTiles(job.in, job.out, session::complete(commandOf(options)),
                                           bytesOf(options.memory), options.dryRun, messages, console.progress());
        console.tell(messages);
        return report;
    }
    session::Document document;
    session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(context, job.in, options.surface->parameters(), console);
    const std::size_t before = document.surface().tree().size();
    const nlohmann::json command = commandOf(options);
    session::run(context, command);
    console.tell(context.messages);
    context.messages.clear();
    if (options.dryRun)
        console.tell("Nothing was written: " + (job.out.empty() ? "the model" : job.out) + " would have " +
                     std::to_string(document.surface().tree().size()) + " of " + std::to_string(before) + " points.");
    else
        session::run(context, {{"op", "save"}, {"path", job.out}});
    console.tell(context.messages);
    return reportOf(command, context, before);
}

void runClean(const CleanArguments& options, OptionSet set, Console& console) {
    if (options.dryRun && options.batch.wanted())
        throw UsageError("--dry-run is of one file, not of many");
    if (!options.batch.wanted()) {
        requireNoBatch(options.batch);
        if (options.out.empty() && !options.dryRun)
            throw UsageError("OUT is required: the model to write");
    }
    const bool limit = has(options.steps, "limit");
    if (!options.duplicates && !options.mixed && options.steps.size() == (limit ? 1 : 0))
        throw UsageError("nothing to do; name at least one of --duplicates, --mixed, --outliers, --denoise, --thin, "
                         "--normals and --orient");
    if (limit && !has(options.steps, "outliers"))
        throw UsageError("--limit belongs to --outliers");
    if (options.batch.wanted()) {
        if (!options.report.empty())
            throw UsageError("--report is of one file; with --into the table has it: --json");
        return runBatch("clean", set, options.batch, {options.in, options.out}, {"ply", isWritableModel, true}, console,
                        [&](const BatchJob& job) { return cleaned(options, job, console); });
    }
    if (!options.dryRun)
        requireOutputs({{"OUT", options.out}, {"--report", options.report}});
    const ordered_json report = cleaned(options, {options.in, options.out}, console);
    if (!options.report.empty())
        io::writeFile(options.report, report.dump(2) + "\n");
}

} // namespace

Action addClean(OptionSet command) {
    auto options = std::make_shared<CleanArguments>();
    command.add("IN", options->in, modelHelp).required();
    command.add("OUT", options->out, "model to write; .ply keeps everything; may be left out with --dry-run");
    for (const session::CommandParameter& p : session::command("clean").parameters)
        if (p.id == std::string_view("duplicates"))
            command.addFlag("--duplicates", options->duplicates, p.tip);
        else if (p.id == std::string_view("mixed"))
            command.addFlag("--mixed", options->mixed, p.tip);
        else if (p.id == std::string_view("viewpoint"))
            command.add("--viewpoint", options->viewpoint, p.tip).typeName("x,y,z").check({viewpointFault});
        else
            addParameter(command, "clean", p, helpOf(p), options->steps);
    command.add("--report", options->report, "JSON file to write the numbers of each step to").typeName("OUT.json");
    command.addFlag("--dry-run", options->dryRun, "tell what would go, and write no model");
    command
        .add(
            "--memory", options->memory,
            "memory to take: LAS files that need more are cleaned in tiles by --duplicates and --outliers statistical, "
            "radius and surface; other steps refuse. Strays in swarms are judged in each tile by itself, so that a few "
            "points in a million may be told otherwise, and far ones among an even choice of the file; normals are not "
            "made")
        .typeName("BYTES[K|M|G]")
        .check({memoryFault});
    addBatchOptions(command, options->batch);
    options->surface = addSurfaceOptions(command, false);
    return [options, command](Console& console) { runClean(*options, command, console); };
}

} // namespace app
