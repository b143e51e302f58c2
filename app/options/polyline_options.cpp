#include "app/options/polyline_options.h"

#include "app/open_model.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/polyline_formats.h"
#include "app/subcommands/subcommand.h"

#include <nlohmann/json.hpp>

namespace app {

surface::TraceOptions PolylineOptions::tracing() const {
    surface::TraceOptions how;
    how.turn = turn;
    return how;
}

void addPolylineOptions(OptionSet command, PolylineOptions& options, const std::string& what,
                        const std::string& columns) {
    std::string tip = "file to write; its ending tells as what. ", type;
    for (const PolylineFormat& row : polylineFormats()) {
        if (row.planar && !options.planar)
            continue;
        tip += std::string(row.ending) + ": " + row.tip + (row.text ? "; " : " " + columns + "; ");
        type += (type.empty() ? "FILE" : "|FILE") + std::string(row.ending);
    }
    tip.replace(tip.size() - 2, 2, ". Without it the curves are only counted and measured");
    command.add("-o,--output", options.out, tip).typeName(type);
    if (options.turns)
        command.add("--turn", options.turn, "angle by which a " + what + " turns from point to point, in radians")
            .check(between(0.001, 1))
            .showDefault();
    command.add("--least", options.least, "leave out " + what + "s shorter than this, in model units")
        .check(atLeast(0))
        .showDefault();
    options.surface = addSurfaceOptions(command, false);
}

void openForPolylines(const PolylineOptions& options, session::Document& document, const base::Progress& progress,
                      Console& console, const char* fault) {
    if (!options.out.empty() && !polylineFormatOf(options.out, options.planar))
        throw UsageError("-o: the file's name must end in " + polylineEndings(options.planar));
    requireOutputs({{"-o", options.out}});
    requireInputsKept({{"-o", options.out}}, {options.model});
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    const surface::Manifold manifold = document.surface().definition().manifold;
    if (manifold == surface::Manifold::Complex && !options.complexes)
        throw base::Error("a complex has no such curves yet", options.model, "use --manifold surface");
    if (manifold == surface::Manifold::Curve)
        throw base::Error(fault, options.model, "use --manifold surface");
}

} // namespace app
