// pointclay boundary: the rims of an open surface (alg. 6) as polylines, in a CSV or OBJ file.
#include "app/open_model.h"
#include "app/polyline_file.h"
#include "app/polyline_options.h"
#include "app/subcommand.h"
#include "core/surface/curves/rims.h"

#include <iostream>

namespace app {

using surface::Rim, surface::RimPoint;

namespace {

void tell(const std::vector<Rim>& rims) {
    if (rims.empty())
        std::cout << "no rims: the surface is closed, or its boundary limit is none\n";
    for (std::size_t i = 0; i < rims.size(); ++i)
        std::cout << "rim " << i << ": length " << rims[i].length() << ", " << rims[i].points.size() << " points, "
                  << (rims[i].closed ? "closed" : "open") << '\n';
}

void run(const PolylineOptions& options, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    openForPolylines(options, document, progress, console, "a curve has ends, not rims");
    std::vector<Rim> rims = findRims(document.surface(), progress, options.tracing());
    std::erase_if(rims, [&](const Rim& rim) { return rim.length() < options.least; });
    if (!options.out.empty())
        writePolylines(options.out, rims, document.provenance().origin, "rim,closed,x,y,z,nx,ny,nz,ox,oy,oz\n",
                       [](CsvWriter& csv, const RimPoint& p) { csv.vector(p.outward); });
    tell(rims);
}

} // namespace

Action addBoundary(CLI::App& command) {
    auto options = std::make_shared<PolylineOptions>();
    command.add_option("MODEL", options->model, modelHelp)->required();
    addPolylineOptions(
        command, *options, "rim",
        "file to write: CSV rows rim,closed,x,y,z,nx,ny,nz,ox,oy,oz (rims counted from 0, longest first; "
        "unit normal; unit direction away from the surface), or polylines in OBJ. Without it the rims are "
        "only counted and measured",
        "RIMS.csv|RIMS.obj");
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
