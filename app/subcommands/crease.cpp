// pointclay crease: edges that stay sharp, by the session's own command, and what there is of them.
#include "app/number_table.h"
#include "app/options/model_command.h"
#include "app/options/output_names.h"
#include "app/usage_error.h"
#include "core/cells/seams.h"
#include "core/io/safe_file.h"

#include <nlohmann/json.hpp>

namespace app {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

struct CreaseArguments : ModelCommand {
    std::string along, report;
    bool detect = false;
};

ordered_json reportOf(const surface::Surface& surface, const std::map<std::string, double>& figures,
                      const base::Progress& progress) {
    std::vector<cells::Seam> seams;
    if (const auto byCells = cells::CellSurface::of(surface))
        seams = cells::traceSeams(*byCells, progress);
    double length = 0;
    for (const cells::Seam& seam : seams)
        length += seam.length();
    ordered_json out{{"cells", cells::countCells(surface.tree().surfels()).cells},
                     {"seams", seams.size()},
                     {"length", length},
                     {"corners", cells::cornersOf(seams).size()}};
    for (const auto& [name, value] : figures) // counts, but for the noise
        out[name] = name == "noise" ? ordered_json(value) : ordered_json(static_cast<std::size_t>(value));
    return out;
}

json lineOf(const CreaseArguments& options, const base::Progress& progress) {
    json out = json::array();
    for (const base::Vec3d& p : readPoints(std::filesystem::path(options.along), progress))
        out.push_back({p.x, p.y, p.z});
    return out;
}

void runCrease(const CreaseArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}, {"--report", options.report}});
    if (options.detect == !options.along.empty())
        throw UsageError("crease needs one of --detect and --along, and not both");
    if (!options.detect && has(options.wish, "angle"))
        throw UsageError("--angle belongs to --detect");
    json given;
    if (options.detect)
        given["detect"] = true;
    else
        given["along"] = lineOf(options, console.progress());
    runModelCommand(options, "crease", given, console, [&](const session::Context& context) {
        if (!options.report.empty())
            io::writeFile(options.report,
                          reportOf(context.document.surface(), context.figures, context.progress).dump(2) + "\n");
    });
}

} // namespace

Action addCrease(OptionSet command) {
    auto options = std::make_shared<CreaseArguments>();
    addModelAndOutput(command, *options);
    command.addFlag("--detect", options->detect, "find creases in the points, in place of those that are there");
    command
        .add("--along", options->along,
             "the line through these points becomes a crease, text with x y z per line or any readable model; "
             "closed where it ends at its beginning")
        .typeName("POINTS");
    for (const session::CommandParameter& p : session::command("crease").parameters)
        if (p.id != std::string_view("detect") && p.id != std::string_view("along"))
            addParameter(command, "crease", p, helpOf(p), options->wish);
    command
        .add("--report", options->report,
             "JSON file to write what the model has then to: cells, seams (curves between corners and ends), "
             "length of all of them in model units, corners; of --detect also noise (spacings) and narrow "
             "(patches that were left smooth), of --along creased and changed (points)")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runCrease(*options, console); };
}

} // namespace app
