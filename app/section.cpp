// pointclay section: where a plane cuts the surface, as polylines in a CSV or OBJ file.
#include "core/surface/section.h"

#include "app/csv_writer.h"
#include "app/open_model.h"
#include "app/polyline_file.h"
#include "app/subcommand.h"
#include "app/surface_options.h"
#include "app/view_options.h"
#include "core/io/safe_file.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;
using surface::SectionCurve, surface::SectionPoint;

namespace {

struct Options {
    std::string model, out, plane;
    double turn = 0.1, least = 0;
    std::shared_ptr<SurfaceOptions> surface;
};

void write(const std::string& target, const std::vector<SectionCurve>& curves, const Vec3d& origin) {
    io::SafeFile file(target);
    if (target.ends_with(".obj")) {
        std::size_t before = 0;
        for (const SectionCurve& curve : curves) {
            file.write(objPolyline(curve.points, curve.closed, before, origin));
            before += curve.points.size();
        }
    } else {
        CsvWriter csv(curveDigits);
        file.write("curve,closed,x,y,z,nx,ny,nz\n");
        for (std::size_t i = 0; i < curves.size(); ++i)
            for (const SectionPoint& p : curves[i].points) {
                csv.integer(static_cast<long long>(i)).integer(curves[i].closed ? 1 : 0);
                csv.vector(p.position + origin).vector(p.normal);
                csv.endRow();
            }
        file.write(csv.take());
    }
    file.commit();
}

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
    if (!options.out.empty() && !options.out.ends_with(".csv") && !options.out.ends_with(".obj"))
        throw UsageError("-o: the file's name must end in .csv or .obj");
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console);
    if (document.surface().definition().manifold == surface::Manifold::Curve)
        throw base::Error("a plane cuts a curve in points, not in curves", options.model,
                          "ask with --manifold surface");
    surface::TraceOptions how;
    how.turn = options.turn;
    const Vec3d origin = document.provenance().origin;
    const base::Plane plane = planeOf(options.plane, origin);
    std::vector<SectionCurve> curves = findSection(document.surface(), plane, progress, how);
    std::erase_if(curves, [&](const SectionCurve& curve) { return curve.length() < options.least; });
    if (!options.out.empty())
        write(options.out, curves, origin);
    tell(curves, plane);
}

} // namespace

Action addSection(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("MODEL", options->model, modelHelp)->required();
    command.add_option("--plane", options->plane, "all places where nx*x + ny*y + nz*z = d, in model units")
        ->type_name("nx,ny,nz,d")
        ->check(CLI::Validator(planeFault, ""))
        ->required();
    command
        .add_option("-o,--output", options->out,
                    "file to write: CSV rows curve,closed,x,y,z,nx,ny,nz (curves counted from 0, longest first; unit "
                    "normal of the surface), or polylines in OBJ. They run counter-clockwise about what is inside, "
                    "seen from where the plane's normal points. Without it the curves are only counted and measured")
        ->type_name("SECTION.csv|SECTION.obj");
    command.add_option("--turn", options->turn, "angle by which a curve turns from point to point, in radians")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
    command.add_option("--least", options->least, "leave out curves shorter than this, in model units")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
