// pointclay crease: edges that stay sharp, by the session's own command, and what there is of them.
#include "app/number_table.h"
#include "app/open_model.h"
#include "app/options/command_options.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/cells/seams.h"
#include "core/io/safe_file.h"
#include "core/process/estimation/part_progress.h"

#include <nlohmann/json.hpp>

namespace app {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

struct Options {
    std::string model, out, along, report;
    bool detect = false;
    GivenParameters wish;
    std::shared_ptr<SurfaceOptions> surface;
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
    for (const auto& [name, value] : figures)
        out[name] = value;
    return out;
}

void run(const Options& options, Console& console) {
    json command = parametersOf(options.wish);
    command["op"] = "crease";
    if (options.detect == !options.along.empty())
        throw UsageError("crease needs one of --detect and --along, and not both");
    const base::Progress progress = console.progress();
    if (options.detect) {
        command["detect"] = true;
    } else {
        command["along"] = json::array();
        for (const base::Vec3d& p : readPoints(std::filesystem::path(options.along), progress))
            command["along"].push_back({p.x, p.y, p.z});
    }
    session::Document document;
    session::Context context{document, {}, process::part(progress, 0, 0.3), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    context.progress = process::part(progress, 0.3, 0.8);
    context.figures.clear();
    session::run(context, command);
    session::run(context, {{"op", "save"}, {"path", options.out}});
    if (!options.report.empty())
        io::writeFile(options.report,
                      reportOf(document.surface(), context.figures, process::part(progress, 0.8, 1)).dump(2) + "\n");
    console.tell(context.messages);
}

} // namespace

Action addCrease(OptionSet command) {
    auto options = std::make_shared<Options>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("-o,--output", options->out, "model to write; .ply keeps everything").typeName("OUT").required();
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
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
