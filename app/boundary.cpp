// pointclay boundary: the rims of an open surface (alg. 6) as polylines, in a CSV or OBJ file.
#include "core/surface/boundary.h"

#include "app/csv_writer.h"
#include "app/open_model.h"
#include "app/polyline_file.h"
#include "app/subcommand.h"
#include "app/surface_options.h"
#include "core/io/safe_file.h"
#include "core/surface/rims.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;
using surface::Rim, surface::RimPoint;

namespace {

struct Options {
    std::string model, out;
    double turn = 0.1, least = 0;
    std::shared_ptr<SurfaceOptions> surface;
};

/// A row for every point, rims counted from 0, in the order along them.
void appendCsv(CsvWriter& csv, const Rim& rim, long long number, const Vec3d& origin) {
    for (const RimPoint& p : rim.points) {
        csv.integer(number).integer(rim.closed ? 1 : 0);
        csv.vector(p.position + origin).vector(p.normal).vector(p.outward);
        csv.endRow();
    }
}

void write(const std::string& target, const std::vector<Rim>& rims, const Vec3d& origin) {
    io::SafeFile file(target);
    if (target.ends_with(".obj")) {
        std::size_t before = 0;
        for (const Rim& rim : rims) {
            file.write(objPolyline(rim.points, rim.closed, before, origin));
            before += rim.points.size();
        }
    } else {
        CsvWriter csv(curveDigits);
        file.write("rim,closed,x,y,z,nx,ny,nz,ox,oy,oz\n");
        for (std::size_t i = 0; i < rims.size(); ++i)
            appendCsv(csv, rims[i], static_cast<long long>(i), origin);
        file.write(csv.take());
    }
    file.commit();
}

void tell(const std::vector<Rim>& rims) {
    if (rims.empty())
        std::cout << "no rims: the surface is closed, or its boundary limit is none\n";
    for (std::size_t i = 0; i < rims.size(); ++i)
        std::cout << "rim " << i << ": length " << rims[i].length() << ", " << rims[i].points.size() << " points, "
                  << (rims[i].closed ? "closed" : "open") << '\n';
}

void run(const Options& options, Console& console) {
    if (!options.out.empty() && !options.out.ends_with(".csv") && !options.out.ends_with(".obj"))
        throw UsageError("-o: the file's name must end in .csv or .obj");
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    if (document.surface().definition().manifold == surface::Manifold::Curve)
        throw base::Error("a curve has ends, not rims", options.model, "ask with --manifold surface");
    surface::TraceOptions how;
    how.turn = options.turn;
    std::vector<Rim> rims = findRims(document.surface(), progress, how);
    std::erase_if(rims, [&](const Rim& rim) { return rim.length() < options.least; });
    if (!options.out.empty())
        write(options.out, rims, document.provenance().origin);
    tell(rims);
}

} // namespace

Action addBoundary(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("MODEL", options->model, modelHelp)->required();
    command
        .add_option("-o,--output", options->out,
                    "file to write: CSV rows rim,closed,x,y,z,nx,ny,nz,ox,oy,oz (rims counted from 0, longest first; "
                    "unit normal; unit direction away from the surface), or polylines in OBJ. Without it the rims are "
                    "only counted and measured")
        ->type_name("RIMS.csv|RIMS.obj");
    command.add_option("--turn", options->turn, "angle by which a rim turns from point to point, in radians")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
    command.add_option("--least", options->least, "leave out rims shorter than this, in model units")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
