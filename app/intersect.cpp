// pointclay intersect: where rays first meet the surface, as CSV rows in their order.
#include "core/surface/intersect.h"
#include "app/csv_writer.h"
#include "app/number_table.h"
#include "app/open_model.h"
#include "app/subcommand.h"
#include "app/surface_options.h"
#include "core/base/parallel.h"
#include "core/io/safe_file.h"

#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;

namespace {

constexpr std::size_t batchSize = 16384;

struct Options {
    std::string model, rays, out;
    std::shared_ptr<SurfaceOptions> surface;
};

std::vector<surface::RayHit<double>> hitInDouble(const surface::Surface& surface, std::span<const base::Rayd> rays) {
    std::vector<surface::RayHit<double>> out(rays.size());
    base::parallelFor(rays.size(), 16, [&](std::size_t i) { out[i] = intersectReference(surface, rays[i]); });
    return out;
}

std::vector<surface::RayHit<double>> hitInFloat(const surface::Surface& surface, std::span<const base::Rayd> rays) {
    std::vector<base::Rayf> near(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        near[i] = {base::cast<float>(rays[i].origin), base::normalized(base::cast<float>(rays[i].direction))};
    std::vector<surface::RayHit<float>> hits(rays.size());
    intersect(surface, near, {}, hits);
    std::vector<surface::RayHit<double>> out(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        out[i].hit = hits[i].hit;
        out[i].t = hits[i].t;
        out[i].position = base::cast<double>(hits[i].position);
        out[i].normal = base::cast<double>(hits[i].normal);
    }
    return out;
}

void write(CsvWriter& csv, const surface::RayHit<double>& hit, const Vec3d& origin) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    csv.integer(hit.hit ? 1 : 0);
    if (hit.hit)
        csv.number(hit.t).vector(hit.position + origin).vector(hit.normal);
    else
        csv.number(nan).vector({nan, nan, nan}).vector({nan, nan, nan});
    csv.endRow();
}

void run(const Options& options, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    std::vector<base::Rayd> rays = readRays(options.rays, progress);
    openModel(context, options.model, options.surface->parameters(), console);
    const Vec3d origin = document.provenance().origin;
    for (base::Rayd& ray : rays)
        ray.origin -= origin;

    io::SafeFile file(options.out);
    CsvWriter csv(options.surface->inDouble() ? 17 : 9);
    file.write("hit,t,x,y,z,nx,ny,nz\n");
    for (std::size_t begin = 0; begin < rays.size(); begin += batchSize) {
        progress.step(static_cast<double>(begin) / static_cast<double>(rays.size()), "Intersecting");
        const auto batch = std::span(rays).subspan(begin, std::min(batchSize, rays.size() - begin));
        for (const auto& hit : (options.surface->inDouble() ? hitInDouble : hitInFloat)(document.surface(), batch))
            write(csv, hit, origin);
        file.write(csv.take());
    }
    file.commit();
}

} // namespace

Action addIntersect(CLI::App& command) {
    auto options = std::make_shared<Options>();
    command.add_option("MODEL", options->model, modelHelp)->required();
    command.add_option("--rays", options->rays, "text with the header ox,oy,oz,dx,dy,dz, in model units")
        ->type_name("RAYS.csv")
        ->required();
    command
        .add_option("-o,--output", options->out,
                    "CSV file to write: hit,t,x,y,z,nx,ny,nz with t in model units and the normal facing against the "
                    "ray; a miss has hit 0 and nan")
        ->type_name("HITS.csv")
        ->required();
    options->surface = addSurfaceOptions(command, true);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
