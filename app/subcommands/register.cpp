// pointclay register: scans brought together, by features where nothing is known of their places, then each one's
// points onto the surfaces of the others; one model of all of them comes out.
#include "app/open_model.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/base/cancel_scope.h"
#include "core/base/short_number.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/session/scans.h"

#include <nlohmann/json.hpp>

namespace app {

using process::Rigid;
using session::Scans;

namespace {

struct RegisterArguments {
    std::vector<std::string> moving;
    std::string fixed, out, report;
    bool global = false;
    std::shared_ptr<SurfaceOptions> surface;
};

Scans opened(const RegisterArguments& options, Console& console) {
    Scans out;
    std::vector<std::string> names{options.fixed};
    names.insert(names.end(), options.moving.begin(), options.moving.end());
    for (const std::string& name : names) {
        session::Document document;
        session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
        openModel(context, name, options.surface->parameters(), console);
        session::add(out, name, document);
    }
    return out;
}

std::vector<double> rowsOf(const Rigid& motion) {
    std::vector<double> out;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c)
            out.push_back(motion.rotation[r][c]);
        out.push_back(motion.translation[static_cast<std::size_t>(r)]);
    }
    out.insert(out.end(), {0, 0, 0, 1});
    return out;
}

/// All of them in the fixed model's coordinates.
io::FileModel fileOf(const Scans& scans) {
    io::FileModel out = scans.documents[0].fileModel();
    out.points = session::together(scans);
    out.hasSupports = out.limitDecided = false;
    out.elements.clear();
    return out;
}

nlohmann::ordered_json reportOf(const Scans& scans) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (std::size_t m = 1; m < scans.placed.size(); ++m)
        out.push_back({{"model", scans.names[m]},
                       {"matrix", rowsOf(session::betweenFiles(scans, m))},
                       {"rms", scans.placed[m].rms},
                       {"overlap", scans.placed[m].overlap},
                       {"held", scans.placed[m].held},
                       {"unique", scans.placed[m].unique}});
    return out;
}

void runRegister(const RegisterArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}, {"--report", options.report}});
    requireModelName(options.out);
    const base::Progress progress = console.progress();
    const base::CancelScope scope(progress.cancel);
    Scans scans = opened(options, console);
    std::vector<std::string> messages;
    session::bring(scans, options.global, messages, process::part(progress, 0.2, 0.9));
    console.tell(messages);
    const auto spacing = static_cast<double>(process::typicalSpacing(scans.placed[0].surface.tree()));
    console.tell("Where models overlap there are points of each. One even layer of them: pointclay clean --thin " +
                 base::shortNumber(spacing, 3) + ", or resample.");
    if (const std::string loss = session::lossOf(scans); !loss.empty())
        console.tell(loss);
    io::write(options.out, fileOf(scans), process::part(progress, 0.9, 1));
    if (!options.report.empty())
        io::writeFile(options.report,
                      reportOf(scans).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

} // namespace

Action addRegister(OptionSet command) {
    auto options = std::make_shared<RegisterArguments>();
    command.add("MOVING", options->moving, "models to move").required();
    command.add("--to", options->fixed, "model that stays where it is").typeName("FIXED").required();
    command
        .add("-o,--output", options->out,
             "model to write: all of them in FIXED's place, with an attribute `scan` that tells whose a point was "
             "(0: FIXED; where it has that attribute itself, the numbers go on from there)")
        .typeName("OUT")
        .required();
    command.addFlag("--global", options->global,
                    "look for the places of the models everywhere, by what their surfaces look like; otherwise they "
                    "begin where they are");
    command
        .add("--report", options->report,
             "JSON file to write: for each moving model its matrix (16 numbers by row), rms and overlap; held: it does "
             "not slide along the others; unique: it was not found to fit nearly as well in another place")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runRegister(*options, console); };
}

} // namespace app
