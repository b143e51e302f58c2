// pointclay section: where a plane cuts the surface, as polylines in a file.
#include "core/surface/curves/section.h"

#include "app/open_model.h"
#include "app/options/polyline_options.h"
#include "app/options/view_options.h"
#include "app/polyline_file.h"
#include "app/subcommands/subcommand.h"

#include <iostream>

namespace app {

using surface::SectionCurve, surface::SectionPoint;

namespace {

struct Options : PolylineOptions {
    std::string plane;
};

/// The area counts holes as such where all curves are closed.
void tell(const std::vector<SectionCurve>& curves, const base::Plane& plane) {
    if (curves.empty())
        std::cout << "no curves: the plane does not cut the surface\n";
    for (std::size_t i = 0; i < curves.size(); ++i) {
        std::cout << "curve " << i << ": length " << curves[i].length() << ", " << curves[i].points.size()
                  << " points, ";
        if (curves[i].closed)
            std::cout << "closed, area " << curves[i].area(plane) << '\n';
        else
            std::cout << "open\n";
    }
}

void run(const Options& options, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    openForPolylines(options, document, progress, console, "a plane cuts a curve in points, not in curves");
    const base::Vec3d origin = document.provenance().origin;
    const base::Plane plane = planeOf(options.plane, origin);
    std::vector<SectionCurve> curves = findSection(document.surface(), plane, progress, options.tracing());
    std::erase_if(curves, [&](const SectionCurve& curve) { return curve.length() < options.least; });
    if (!options.out.empty())
        writePolylines(options.out, curves, origin, drawingFrame(plane.normal, document.up()),
                       "curve,closed,x,y,z,nx,ny,nz\n", [](CsvWriter&, const SectionPoint&) {});
    tell(curves, plane);
}

} // namespace

Action addSection(OptionSet command) {
    auto options = std::make_shared<Options>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("--plane", options->plane, "the points where nx*x + ny*y + nz*z = d, in model units")
        .typeName("nx,ny,nz,d")
        .check({planeFault})
        .required();
    options->planar = true;
    addPolylineOptions(command, *options, "curve",
                       "curve,closed,x,y,z,nx,ny,nz (curves counted from 0, longest first; unit normal of the surface; "
                       "counter-clockwise around the inside, seen from the side that the plane's normal points to)");
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
