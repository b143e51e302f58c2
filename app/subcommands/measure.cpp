// pointclay measure: area, volume, distances to another model and shapes fitted, as text or as JSON (app/README 2.6).
#include "app/measure_report.h"
#include "app/open_model.h"
#include "app/options/option_checks.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

namespace {

struct Options {
    std::string model, other, shape;
    std::vector<std::string> what;
    bool json = false;
    std::shared_ptr<SurfaceOptions> surface;

    bool asks(const char* name) const { return std::find(what.begin(), what.end(), name) != what.end(); }
};

void refuseCurve(const surface::Surface& surface, const std::string& model) {
    if (surface.definition().manifold == surface::Manifold::Curve)
        throw base::Error("a curve has neither area nor volume, and no distances to it are told", model,
                          "use --manifold surface");
}

/// Area and volume where nothing is named.
Measurements measure(const Options& options, Console& console) {
    const base::Progress progress = console.progress();
    const base::CancelScope scope(progress.cancel);
    session::Document document, other;
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    const bool any = !options.what.empty() || !options.other.empty() || !options.shape.empty();
    Measurements out;
    out.origin = document.provenance().origin;
    out.area = options.asks("area") || !any;
    out.volume = options.asks("volume") || !any;
    refuseCurve(document.surface(), options.model);
    if (out.area || out.volume)
        out.extent = mesh::extentOf(document.surface(), 0, process::part(progress, 0, 0.5));
    if (!options.shape.empty())
        out.fit = process::fitPrimitive(
            document.surface().tree().surfels(),
            base::rowOf(process::shapeTable(), options.shape, {"there is no shape '%'", "", "known are %"}).shape,
            process::part(progress, 0.5, 0.6));
    if (!options.other.empty()) {
        session::Context beside{other, {}, progress, {}, 0, {}, nullptr};
        openModel(beside, options.other, nlohmann::json::object(), console);
        refuseCurve(other.surface(), options.other);
        out.deviation = process::deviationOf(document.surface().tree(), other.surface(),
                                             document.provenance().origin - other.provenance().origin,
                                             process::part(progress, 0.6, 1));
        if (out.deviation->count == 0)
            throw base::Error("no surfel has a foot on the surface of " + options.other, options.model,
                              "check that both models are in one place and of one size");
    }
    return out;
}

} // namespace

Action addMeasure(OptionSet command) {
    auto options = std::make_shared<Options>();
    command.add("MODEL", options->model, modelHelp).required();
    command
        .add("WHAT", options->what,
             "area, volume or both, of the surface that the points define; volume where it is closed. Both "
             "where nothing else is asked for")
        .typeName("")
        .check(oneOf({"area", "volume"}));
    command
        .add("--to", options->other,
             std::string("measure from each surfel to the nearest place of this model's surface, positive on the side "
                         "that its normals point to: ") +
                 modelHelp)
        .typeName("OTHER");
    command
        .add("--fit", options->shape,
             "fit a shape to the surfels, whose strays do not count, and tell its place, size and residual")
        .typeName("plane|sphere|cylinder|cone|torus")
        .check(idOf(process::shapeTable()));
    command.addFlag("--json", options->json, "print a JSON object, lengths in model units");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) {
        const Measurements found = measure(*options, console);
        console.clear();
        if (options->json)
            std::cout << measurementsJson(found).dump(2) << "\n";
        else
            std::cout << measurementsText(found);
    };
}

} // namespace app
