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

/// By its length: points are denser where it bends.
base::Vec3d middleOf(const BoundaryCurve& curve) {
    base::Vec3d sum;
    double length = 0;
    const std::size_t count = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i) {
        const base::Vec3d a = curve.points[i].position, b = curve.points[(i + 1) % count].position;
        const double piece = base::distance(a, b);
        sum += (a + b) * (piece / 2);
        length += piece;
    }
    return length > 0 ? sum / length : count > 0 ? curve.points.front().position : sum;
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
