// pointclay section: where a plane, or many at equal heights, cut the surface, as polylines in a file.

#include "app/open_model.h"
#include "app/options/option_checks.h"
#include "app/options/polyline_options.h"
#include "app/options/view_options.h"
#include "app/polyline_file.h"
#include "app/subcommands/subcommand.h"
#include "core/base/error.h"
#include "core/cells/cell_section.h"
#include "core/complexes/complex_section.h"
#include "core/process/estimation/part_progress.h"

#include <cmath>
#include <iostream>

namespace app {

using surface::SectionCurve, surface::SectionPoint;

namespace {

struct SectionArguments : PolylineOptions {
    std::string plane;
    double every = 0; ///< 0: one plane
};

/// The curves of one plane.
struct Level {
    base::Plane plane;
    double height = 0; ///< in the file's coordinates
    std::vector<SectionCurve> curves;
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

void tellLevels(const std::vector<Level>& levels) {
    if (levels.empty())
        std::cout << "no curves: no plane at these heights cuts the surface\n";
    for (const Level& level : levels) {
        double length = 0, area = 0;
        bool closed = true;
        for (const SectionCurve& curve : level.curves) {
            length += curve.length();
            closed = closed && curve.closed;
            area += curve.closed ? curve.area(level.plane) : 0;
        }
        std::cout << "height " << level.height << ": " << level.curves.size()
                  << (level.curves.size() == 1 ? " curve, length " : " curves, length ") << length;
        if (closed && !level.curves.empty())
            std::cout << ", area " << area;
        std::cout << '\n';
    }
}

/// The one that was told, or without it the ground.
base::Plane firstPlane(const SectionArguments& options, const session::Document& document, const base::Vec3d& origin) {
    if (!options.plane.empty())
        return planeOf(options.plane, origin);
    return base::Plane{base::upRow(document.up()).up, 0}.relativeTo(origin);
}

/// Heights that the model may reach, from below.
std::vector<double> heightsOf(const SectionArguments& options, const session::Document& document,
                              const base::Plane& first, double offset) {
    constexpr double most = 1e5;
    const base::Box3f box = document.surface().tree().bounds();
    const base::Vec3d middle = base::cast<double>(box.centre()), half = base::cast<double>(box.hi) - middle;
    const base::Vec3d& n = first.normal;
    const double reach = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z +
                         static_cast<double>(document.surface().tree().maxSupport());
    const double low = std::ceil((first.distance(middle) - reach) / options.every),
                 high = std::floor((first.distance(middle) + reach) / options.every);
    if (!(high - low <= most)) // infinite ones, too
        throw base::Error("so many heights that nobody could look at them", "--every", "take them farther apart");
    std::vector<double> out;
    for (double k = 0; k <= high - low; ++k) // beyond 2^53 ++low would be low
        out.push_back(offset + (low + k) * options.every);
    return out;
}

std::vector<Level> levelsOf(const SectionArguments& options, const session::Document& document,
                            const base::Vec3d& origin, const base::Progress& progress) {
    const base::Plane first = firstPlane(options, document, origin);
    const double offset = first.relativeTo(-origin).offset; // in the file's coordinates
    std::vector<double> heights{offset};
    if (options.every > 0)
        heights = heightsOf(options, document, first, offset);
    std::vector<Level> out;
    const surface::Surface& model = document.surface();
    const auto cells = cells::CellSurface::of(model);
    const auto complex = complexes::Complex::of(model);
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const auto done = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(heights.size()); };
        Level level{{first.normal, first.offset + (heights[k] - offset)}, heights[k], {}};
        const base::Progress step = process::part(progress, done(k), done(k + 1));
        level.curves = complex ? complexes::findSection(*complex, level.plane, step, options.tracing())
                       : cells ? cells::findSection(*cells, level.plane, step, options.tracing())
                               : surface::findSection(model, level.plane, step, options.tracing());
        std::erase_if(level.curves, [&](const SectionCurve& curve) { return curve.length() < options.least; });
        if (options.every == 0 || !level.curves.empty())
            out.push_back(std::move(level));
    }
    return out;
}

void write(const SectionArguments& options, const session::Document& document, const std::vector<Level>& levels,
           const base::Vec3d& origin) {
    std::vector<SectionCurve> all;
    std::vector<double> heights;
    for (const Level& level : levels)
        for (const SectionCurve& curve : level.curves) {
            all.push_back(curve);
            heights.insert(heights.end(), curve.points.size(), level.height);
        }
    const base::Vec3d normal = firstPlane(options, document, origin).normal;
    std::size_t at = 0; // points come in their order
    writePolylines(options.out, all, origin, drawingFrame(normal, document.up()),
                   options.every > 0 ? "curve,closed,x,y,z,nx,ny,nz,height\n" : "curve,closed,x,y,z,nx,ny,nz\n",
                   [&](CsvWriter& csv, const SectionPoint&) {
                       if (options.every > 0)
                           csv.number(heights[at++]);
                   });
}

void runSection(const SectionArguments& options, Console& console) {
    if (options.plane.empty() && !(options.every > 0))
        throw UsageError("give --plane, --every or both");
    session::Document document;
    const base::Progress progress = console.progress();
    openForPolylines(options, document, progress, console, "a plane cuts a curve in points, not in curves");
    const base::Vec3d origin = document.provenance().origin;
    const std::vector<Level> levels = levelsOf(options, document, origin, progress);
    if (!options.out.empty())
        write(options, document, levels, origin);
    if (options.every > 0)
        tellLevels(levels);
    else
        tell(levels[0].curves, levels[0].plane);
}

} // namespace

Action addSection(OptionSet command) {
    auto options = std::make_shared<SectionArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("--plane", options->plane, "the points where nx*x + ny*y + nz*z = d, in model units")
        .typeName("nx,ny,nz,d")
        .check({planeFault});
    command
        .add("--every", options->every,
             "contour lines: sections this far apart over all of the model, in model units, one of them at --plane; "
             "without it level ones, counted from height 0")
        .typeName("STEP")
        .check(above(0));
    options->planar = true;
    options->complexes = true;
    addPolylineOptions(
        command, *options, "curve",
        "curve,closed,x,y,z,nx,ny,nz (curves counted from 0, longest first; unit normal of the surface; "
        "counter-clockwise around the inside, seen from the side that the plane's normal points to; with --every "
        "then height, along the unit normal)");
    return [options](Console& console) { runSection(*options, console); };
}

} // namespace app
