// pointclay mesh: the surface as triangles, by marching cubes or by restricted Delaunay triangulation, in a file.
#include "app/mesh_report.h"
#include "app/open_model.h"
#include "app/options/batch_options.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/io/mesh_formats.h"
#include "core/io/safe_file.h"
#include "core/mesh/complexes/complex_mesh.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/curve_tube.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

namespace {

struct MeshArguments {
    std::string model, out, method = "marching-cubes", report;
    mesh::MarchingOptions marching;
    mesh::DelaunayOptions delaunay;
    mesh::Finishing finishing;
    double adaptive = 0;
    bool check = false;
    BatchOptions batch;
    std::shared_ptr<SurfaceOptions> surface;

    bool isDelaunay() const { return method == "delaunay"; }
};

void checkUsage(const MeshArguments& options, OptionSet command) {
    if (!options.batch.wanted() && !io::meshFormatOf(options.out))
        throw UsageError("-o: the file's name must end in one of " + io::meshExtensions());
    const auto onlyWith = [&](const char* method, std::initializer_list<const char*> names) {
        for (const char* name : names)
            if (command.has(name) && options.method != method)
                throw UsageError(std::string(name) + " goes with --method " + method);
    };
    onlyWith("delaunay", {"--angle", "--size", "--distance"});
    onlyWith("marching-cubes", {"--cell"});
}

void tellCount(Console& console, std::size_t count, const char* what) {
    if (count > 0)
        console.tell(std::to_string(count) + what);
}

mesh::Mesh makeByCubes(const MeshArguments& options, const surface::Surface& surface, Console& console,
                       const base::Progress& progress) {
    mesh::MarchingReport report;
    mesh::Mesh out = marchingCubes(surface, options.marching, report, progress);
    tellCount(console, report.foldsClosed, " loops at folds were closed.");
    return out;
}

mesh::Mesh makeByDelaunay(const MeshArguments& options, const surface::Surface& surface, Console& console,
                          const base::Progress& progress) {
    mesh::DelaunayReport report;
    mesh::Mesh out = restrictedDelaunay(surface, options.delaunay, report, progress);
    tellCount(console, report.unrefined,
              " triangles were left out: refinement could not bring them within the limits asked for, as at folds.");
    tellCount(
        console, report.missed,
        " triangles miss the limits asked for: they close the mesh where points leave gaps or sheets run together.");
    tellCount(console, report.removed, " triangles were left out where more than two met at an edge.");
    tellCount(console, report.trimmed, " triangles were left out because they cut others at folds.");
    tellCount(console, report.foldsClosed, " loops at folds were closed.");
    return out;
}

mesh::Mesh makeByPatches(const MeshArguments& options, const complexes::Complex& complex,
                         const base::Progress& progress) {
    if (options.isDelaunay() || options.adaptive > 0)
        throw base::Error("a complex is meshed patch by patch, in cubes of one size", options.model,
                          "leave out --method and --adaptive");
    return mesh::meshOfComplex(complex, {options.marching.cell}, progress);
}

void judge(const MeshArguments& options, const mesh::Mesh& mesh, const surface::Surface& surface,
           const base::Progress& progress) {
    const double spacing = double(process::typicalSpacing(surface.tree()));
    const mesh::Report report = mesh::check(mesh, surface, progress);
    if (!options.report.empty())
        io::writeFile(options.report, reportJson(report, spacing).dump(2) + "\n");
    if (options.check)
        std::cout << reportTable(report, spacing);
}

/// One file; how many there are of what.
nlohmann::ordered_json meshed(const MeshArguments& options, const BatchJob& job, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, job.in, options.surface->parameters(), console);
    const surface::Surface surface = process::shownAs(document.surface(), progress); // a curve's tube
    const bool judged = options.check || !options.report.empty();
    const base::Progress making = process::part(progress, 0, judged ? 0.7 : 1);
    const auto complex = complexes::Complex::of(surface);
    const mesh::Mesh mesh = complex                ? makeByPatches(options, *complex, making)
                            : options.isDelaunay() ? makeByDelaunay(options, surface, console, making)
                                                   : makeByCubes(options, surface, console, making);
    io::writeMesh(job.out, mesh, document.provenance().origin, progress);
    if (judged)
        judge(options, mesh, surface, process::part(progress, 0.7, 1));
    return {{"vertices", mesh.positions.size()}, {"triangles", mesh.triangles.size()}};
}

void runMesh(const MeshArguments& options, OptionSet command, Console& console) {
    if (!options.batch.wanted() || !options.out.empty())
        requireOneOutput(options.batch, options.out);
    checkUsage(options, command);
    if (!options.batch.wanted()) {
        requireOutputs({{"-o", options.out}, {"--report", options.report}});
        meshed(options, {options.model, options.out}, console);
        return;
    }
    if (!options.report.empty() || options.check)
        throw UsageError("--check and --report are of one file, not of many");
    const auto writes = [](const std::string& name) { return io::meshFormatOf(name) != nullptr; };
    runBatch("mesh", command, options.batch, {options.model}, {"ply", writes, false}, console,
             [&](const BatchJob& job) { return meshed(options, job, console); });
}

void addDelaunayOptions(OptionSet command, mesh::DelaunayOptions& options) {
    command.add("--angle", options.angle, "smallest angle of a triangle away from sharp edges, in degrees")
        .check(between(0, 30))
        .showDefault()
        .group("Delaunay");
    command
        .add("--size", options.size,
             "largest radius of the ball through a triangle's corners with its centre on the surface, in model "
             "units [the median spacing; with --adaptive 8 times that]")
        .check(above(0))
        .group("Delaunay");
    command
        .add("--distance", options.distance,
             "largest distance of a triangle from the surface, in model units [a tenth of the median spacing; "
             "with --adaptive its TOLERANCE]")
        .check(above(0))
        .group("Delaunay");
}

void addMarchingOptions(OptionSet command, mesh::MarchingOptions& options) {
    command
        .add("--cell", options.cell,
             "edge length of the cubes, in model units [the median spacing, of each body that stands apart; the "
             "spacing at each place where that varies much, and less in walls thinner than that]")
        .check(above(0))
        .group("Marching cubes");
}

} // namespace

Action addMesh(OptionSet command) {
    auto options = std::make_shared<MeshArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    std::string formats = "mesh file to write, in file coordinates; beside positions and triangles it keeps";
    for (const io::MeshFormatRow& row : io::meshFormatTable())
        formats += std::string("\n  .") + row.id + ": " + row.holds;
    command.add("-o,--output", options->out, formats).typeName("OUT");
    command
        .add("--method", options->method,
             "marching-cubes: fast, follows a grid; delaunay: well-shaped triangles, as few as needed")
        .check(oneOf({"marching-cubes", "delaunay"}))
        .showDefault();
    command
        .add(
            "--adaptive", options->adaptive,
            "large triangles where the surface is flat: as large as they can be while their middles stay this close to "
            "it, in model units; --cell is then the smallest cube, whose triangles are as far away as they are [all of "
            "one size]")
        .typeName("TOLERANCE")
        .check(above(0));
    addMarchingOptions(command, options->marching);
    addDelaunayOptions(command, options->delaunay);
    command.addFlag("--close-folds", options->finishing.closeFolds,
                    "close all loops of up to " + std::to_string(options->finishing.longestFold) +
                        " edges where the surface ends without a boundary of its own, as at folds [marching cubes: "
                        "short ones, where the surface goes on]");
    command.addFlag("--drop-small", options->finishing.dropSmall,
                    "leave out pieces of fewer than " + std::to_string(options->finishing.smallPiece) + " triangles");
    command.addFlag("--check", options->check,
                    "print a report on the mesh: pieces, boundary loops, genus, angles, distances to the surface, "
                    "self-intersections");
    command.add("--report", options->report, "JSON file to write the same report to, lengths in model units")
        .typeName("OUT.json");
    addBatchOptions(command, options->batch);
    options->surface = addSurfaceOptions(command, false);
    return [options, command](Console& console) {
        options->delaunay.finishing = options->marching.finishing = options->finishing;
        options->delaunay.adaptive = options->marching.adaptive = options->adaptive;
        runMesh(*options, command, console);
    };
}

} // namespace app
