// pointclay boundary: the boundary loops of an open surface (surface/README 5.3), or of a complex, as polylines in a
// file.
#include "app/open_model.h"
#include "app/options/polyline_options.h"
#include "app/polyline_file.h"
#include "app/subcommands/subcommand.h"
#include "core/complexes/rims.h"
#include "core/session/place_text.h"
#include "core/surface/curves/boundary_curves.h"

#include <algorithm>
#include <iostream>

namespace app {

using surface::BoundaryCurve, surface::BoundaryPoint;

namespace {

/// The middle of its points.
base::Vec3d middleOf(const BoundaryCurve& curve) {
    base::Vec3d sum;
    for (const BoundaryPoint& p : curve.points)
        sum += p.position;
    return sum / static_cast<double>(std::max<std::size_t>(curve.points.size(), 1));
}

void tell(const std::vector<BoundaryCurve>& curves, const session::Document& document) {
    if (curves.empty())
        std::cout << "no boundary: the surface is closed, or its boundary limit is none\n";
    const auto size = static_cast<double>(document.surface().tree().bounds().diagonal());
    for (std::size_t i = 0; i < curves.size(); ++i)
        std::cout << "boundary curve " << i << ": length " << curves[i].length() << ", " << curves[i].points.size()
                  << " points, " << (curves[i].closed ? "closed" : "open") << ", about "
                  << session::placeText(middleOf(curves[i]) + document.provenance().origin, size) << '\n';
}

void runBoundary(const PolylineOptions& options, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    openForPolylines(options, document, progress, console, "a curve has ends, not a boundary");
    const auto complex = complexes::Complex::of(document.surface());
    std::vector<BoundaryCurve> curves =
        complex ? findRims(*complex, progress) : findBoundaryCurves(document.surface(), progress, options.tracing());
    std::erase_if(curves, [&](const BoundaryCurve& curve) { return curve.length() < options.least; });
    if (!options.out.empty())
        writePolylines(options.out, curves, document.provenance().origin, {}, "rim,closed,x,y,z,nx,ny,nz,ox,oy,oz\n",
                       [](CsvWriter& csv, const BoundaryPoint& p) { csv.vector(p.outward); });
    tell(curves, document);
}

} // namespace

Action addBoundary(OptionSet command) {
    auto options = std::make_shared<PolylineOptions>();
    options->complexes = true;
    command.add("MODEL", options->model, modelHelp).required();
    addPolylineOptions(command, *options, "boundary curve",
                       "rim,closed,x,y,z,nx,ny,nz,ox,oy,oz (curves counted from 0, longest first; unit normal; unit "
                       "direction away from the surface)");
    return [options](Console& console) { runBoundary(*options, console); };
}

} // namespace app
