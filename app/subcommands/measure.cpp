// pointclay measure: area, volume, distances, ways, angles, thickness and shapes, as text, as JSON, as a table, or as
// attributes of the model (app/README 2.6).
#include "app/measure_report.h"
#include "app/open_model.h"
#include "app/options/number_list.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/polyline_file.h"
#include "app/subcommands/subcommand.h"
#include "app/writable_models.h"
#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/measuring/geodesic.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;

namespace {

struct MeasureArguments {
    std::string model, other, shape, range, path, csv, out, colours;
    std::vector<std::string> what, distance, geodesic, angle, thicknessAt;
    std::size_t bins = 0;
    bool json = false, thickness = false;
    std::shared_ptr<SurfaceOptions> surface;

    bool asks(const char* name) const { return std::find(what.begin(), what.end(), name) != what.end(); }
    bool asksNothing() const {
        return what.empty() && other.empty() && shape.empty() && distance.empty() && geodesic.empty() &&
               angle.empty() && thicknessAt.empty() && !thickness;
    }
};

std::string placeFault(const std::string& text) {
    double v[3];
    return parseNumbers(text, ',', v) && std::isfinite(v[0] + v[1] + v[2])
               ? ""
               : "'" + text + "' is not a place; write x,y,z";
}

std::string rangeFault(const std::string& text) {
    double v[2];
    return parseNumbers(text, ',', v) && v[0] < v[1] && std::isfinite(v[1] - v[0])
               ? ""
               : "'" + text + "' is not a range; write LOW,HIGH";
}

Vec3d placeOf(const std::string& text) {
    double v[3];
    parseNumbers(text, ',', v);
    return {v[0], v[1], v[2]};
}

std::optional<std::pair<double, double>> rangeOf(const MeasureArguments& options) {
    double v[2];
    if (options.range.empty() || !parseNumbers(options.range, ',', v))
        return {};
    return std::pair{v[0], v[1]};
}

void refuseCurve(const surface::Surface& surface, const std::string& model) {
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) +
                              " has neither area nor volume that is told, nor distances to it",
                          model, "use --manifold surface");
}

/// What options belong to is asked for, too.
void checkUsage(const MeasureArguments& options) {
    const auto needs = [](bool given, bool there, const char* name, const char* of) {
        if (given && !there)
            throw UsageError(std::string(name) + " belongs to " + of);
    };
    const bool perSurfel = !options.other.empty() || options.thickness;
    needs(options.bins > 0, !options.other.empty(), "--histogram", "--to");
    needs(!options.range.empty(), options.bins > 0 || !options.colours.empty(), "--range", "--histogram or --colours");
    needs(!options.path.empty(), !options.geodesic.empty(), "--path", "--geodesic");
    needs(!options.csv.empty(), perSurfel, "--csv", "--to or --thickness");
    needs(!options.out.empty(), perSurfel, "-o", "--to or --thickness");
    needs(!options.colours.empty(), !options.out.empty(), "--colours", "-o");
    needs(options.colours == "deviation", !options.other.empty(), "--colours deviation", "--to");
    needs(options.colours == "thickness", options.thickness, "--colours thickness", "--thickness");
    if (!options.path.empty() && !polylineFormatOf(options.path, false))
        throw UsageError("--path: the file's name must end in " + polylineEndings(false));
    requireOutputs({{"-o", options.out}, {"--csv", options.csv}, {"--path", options.path}});
    requireInputsKept({{"--csv", options.csv}, {"--path", options.path}}, {options.model, options.other});
    if (!options.out.empty())
        requireModelName(options.out);
}

double angleOf(const surface::Surface& surface, const std::vector<Vec3d>& places, const Vec3d& origin) {
    Vec3d a, b;
    if (places.size() == 3) {
        a = places[0] - places[1], b = places[2] - places[1];
        if (!(length(a) > 0) || !(length(b) > 0))
            throw base::Error("there is no angle where two of its places are one", "--angle", "give three places");
    } else {
        a = process::footOf(surface, places[0] - origin).normal;
        b = process::footOf(surface, places[1] - origin).normal;
    }
    const bool sides = places.size() == 3 || surface.tree().layout()->oriented;
    return std::atan2(length(cross(a, b)), sides ? dot(a, b) : std::abs(dot(a, b)));
}

/// What is told by places.
void measurePlaces(const MeasureArguments& options, const surface::Surface& surface, Measurements& out,
                   const base::Progress& progress) {
    if (!options.distance.empty())
        out.distance = {placeOf(options.distance[0]), placeOf(options.distance[1])};
    if (!options.geodesic.empty())
        out.geodesic = process::geodesic(surface, placeOf(options.geodesic[0]) - out.origin,
                                         placeOf(options.geodesic[1]) - out.origin, progress);
    if (!options.angle.empty()) {
        MeasuredAngle angle;
        for (const std::string& text : options.angle)
            angle.places.push_back(placeOf(text));
        angle.rad = angleOf(surface, angle.places, out.origin);
        out.angle = std::move(angle);
    }
    for (const std::string& text : options.thicknessAt)
        out.thicknessAt.push_back(process::thicknessAt(surface, placeOf(text) - out.origin));
}

void measureDeviation(const MeasureArguments& options, const session::Document& document, Measurements& out,
                      Console& console, const base::Progress& progress) {
    session::Document other;
    session::Context beside{other, {}, console.progress(), {}, 0, {}, nullptr};
    openModel(beside, options.other, nlohmann::json::object(), console);
    refuseCurve(other.surface(), options.other);
    out.model.deviation = process::deviationsOf(document.surface().tree(), other.surface(),
                                                out.origin - other.provenance().origin, progress);
    if (out.model.deviation->figures.count == 0)
        throw base::Error("no surfel has a foot on the surface of " + options.other, options.model,
                          "check that both models are in one place and of one size");
    if (options.bins > 0)
        out.histogram = process::histogramOf(out.model.deviation->distance, options.bins,
                                             out.model.deviation->figures.sided, rangeOf(options));
}

/// Area and volume where nothing is named.
Measurements measure(const MeasureArguments& options, const session::Document& document, Console& console,
                     const base::Progress& progress) {
    Measurements out;
    out.origin = document.provenance().origin;
    out.area = options.asks("area") || options.asksNothing();
    out.volume = options.asks("volume") || options.asksNothing();
    const surface::Surface& surface = document.surface();
    refuseCurve(surface, options.model);
    if (out.area || out.volume)
        out.extent = mesh::extentOf(surface, 0, process::part(progress, 0, 0.4));
    if (!options.shape.empty())
        out.fit = process::fitPrimitive(
            surface.tree().surfels(),
            base::rowOf(process::shapeTable(), options.shape, {"there is no shape '%'", "", "known are %"}).shape,
            process::part(progress, 0.4, 0.5));
    measurePlaces(options, surface, out, process::part(progress, 0.5, 0.7));
    if (options.thickness)
        out.model.thickness = process::thicknessesOf(surface, process::part(progress, 0.7, 0.8));
    if (!options.other.empty())
        measureDeviation(options, document, out, console, process::part(progress, 0.8, 1));
    return out;
}

/// A row for every surfel.
void writeTable(const std::string& path, const session::Document& document, const Measurements& found) {
    const auto& [deviation, thickness, colours, range] = found.model;
    io::SafeFile file(path);
    file.write(std::string("x,y,z") + (deviation ? ",deviation,status" : "") + (thickness ? ",thickness" : "") + "\n");
    CsvWriter csv(false, found.origin);
    const surfel::SurfelList points = document.surface().tree().surfels();
    for (std::size_t i = 0; i < points.size(); ++i) {
        csv.place(base::cast<double>(points.items[i].position) + found.origin);
        if (deviation)
            csv.number(deviation->distance[i]).word(surface::statusName(deviation->status[i]));
        if (thickness)
            csv.number(thickness->at[i]);
        csv.endRow();
        if (i % 65536 == 0)
            file.write(csv.take());
    }
    file.write(csv.take());
    file.commit();
}

/// What goes to files, all of which are whole or not there.
void writeFiles(const MeasureArguments& options, session::Context& context, Measurements& found) {
    if (!options.path.empty())
        writePolylines(options.path, std::vector<process::Geodesic>{*found.geodesic}, found.origin, {},
                       "curve,closed,x,y,z,nx,ny,nz\n", [](CsvWriter&, const process::GeodesicPoint&) {});
    if (!options.csv.empty())
        writeTable(options.csv, context.document, found);
    if (options.out.empty())
        return;
    found.model.colours = options.colours;
    if (options.bins == 0 || !options.colours.empty())
        found.model.range = rangeOf(options);
    context.document.commit(session::withMeasured(context.document.surface(), found.model), "Measure");
    session::run(context, {{"op", "save"}, {"path", options.out}});
}

void runMeasure(const MeasureArguments& options, Console& console) {
    checkUsage(options);
    const base::Progress progress = console.progress();
    const base::CancelScope scope(progress.cancel);
    session::Document document;
    session::Context context{document, {}, process::part(progress, 0, 0.3), {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    Measurements found = measure(options, document, console, process::part(progress, 0.3, 1));
    writeFiles(options, context, found);
    console.clear();
    console.tell(context.messages);
    if (options.json)
        std::cout << measurementsJson(found).dump(2) << "\n";
    else
        std::cout << measurementsText(found);
}

void addPlaceOptions(OptionSet command, MeasureArguments& options) {
    const Check place{placeFault};
    command.add("--distance", options.distance, "distance of two places, in a straight line")
        .text("A B")
        .values(2, 2)
        .check(place);
    command
        .add("--geodesic", options.geodesic,
             "length of the shortest way along the surface from one place to another, which are x,y,z in the file's "
             "coordinates; it begins and ends at the surface's nearest places")
        .text("A B")
        .values(2, 2)
        .check(place);
    command.add("--path", options.path, "file to write that way to; CSV has curve,closed,x,y,z,nx,ny,nz")
        .typeName("FILE.csv|FILE.obj|FILE.dxf");
    command
        .add("--angle", options.angle,
             "of three places the angle at the second one, of two the angle between the surface's normals")
        .text("A B [C]")
        .values(2, 3)
        .check(place);
    command
        .add("--thickness-at", options.thicknessAt,
             "thickness at a place: from the surface there straight inwards to the other side; may be given again")
        .typeName("A")
        .oneAtATime()
        .check(place);
}

void addSurfelOptions(OptionSet command, MeasureArguments& options) {
    command
        .add("--to", options.other,
             std::string("measure from each surfel to the nearest place of this model's surface, positive on the side "
                         "that its normals point to: ") +
                 modelHelp)
        .typeName("OTHER");
    command.add("--histogram", options.bins, "tell how often which distances occur, in so many bins, with sign")
        .typeName("BINS")
        .check(between(1, 100000));
    command.addFlag("--thickness", options.thickness, "thickness under every surfel: least, median, most");
    command.add("--range", options.range, "what bins and colours span, instead of all distances")
        .typeName("LOW,HIGH")
        .check({rangeFault});
    command.add("--csv", options.csv, "file to write a row for each surfel to: x,y,z,deviation,status,thickness")
        .typeName("FILE.csv");
    command
        .add("-o,--output", options.out, "model to write, with what was measured as attributes deviation and thickness")
        .typeName("OUT");
    command.add("--colours", options.colours, "colour its points by one of them")
        .typeName("deviation|thickness")
        .check(oneOf({"deviation", "thickness"}));
}

} // namespace

Action addMeasure(OptionSet command) {
    auto options = std::make_shared<MeasureArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command
        .add("WHAT", options->what,
             "area, volume or both, of the surface that the points define; volume where it is closed. Both "
             "where nothing else is asked for")
        .typeName("")
        .check(oneOf({"area", "volume"}));
    addPlaceOptions(command, *options);
    addSurfelOptions(command, *options);
    command
        .add("--fit", options->shape,
             "fit a shape to the surfels, whose strays do not count, and tell its place, size and residual")
        .typeName("plane|sphere|cylinder|cone|torus")
        .check(idOf(process::shapeTable()));
    command.addFlag("--json", options->json, "print a JSON object, lengths in model units");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runMeasure(*options, console); };
}

} // namespace app
