// pointclay intersect: where rays meet the surface, as CSV rows in their order.
#include "core/surface/rays/intersect.h"
#include "app/csv_writer.h"
#include "app/number_table.h"
#include "app/open_model.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/base/parallel.h"
#include "core/cells/cell_rays.h"
#include "core/complexes/complex_rays.h"
#include "core/io/safe_file.h"
#include "core/process/curve_tube.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;

namespace {

constexpr std::size_t batchSize = 16384;

struct IntersectArguments {
    std::string model, rays, out, policy = "fast", hits = "first";
    std::shared_ptr<SurfaceOptions> surface;
};

using Hit = surface::RayHit<double>;

Hit inDouble(const surface::RayHit<float>& hit) {
    Hit out;
    out.hit = hit.hit;
    out.t = hit.t;
    out.position = base::cast<double>(hit.position);
    out.normal = base::cast<double>(hit.normal);
    return out;
}

/// One batch of rays against a surface, with or without cells, in one precision, in the ways that --hits names.
template <class Surface>
class Batch {
  public:
    Batch(const Surface& surface, std::span<const base::Rayd> rays, const surface::IntersectOptions& options,
          bool precise)
        : m_surface(surface), m_rays(rays), m_options(options), m_precise(precise) {
        for (const base::Rayd& ray : precise ? std::span<const base::Rayd>() : rays)
            m_near.push_back({base::cast<float>(ray.origin), base::normalized(base::cast<float>(ray.direction))});
    }

    std::vector<Hit> first() const {
        std::vector<Hit> out(m_rays.size());
        if (m_precise) {
            each([&](std::size_t i) { out[i] = intersectReference(m_surface, m_rays[i], m_options); });
        } else {
            std::vector<surface::RayHit<float>> hits(m_rays.size());
            intersect(m_surface, m_near, m_options, hits);
            std::transform(hits.begin(), hits.end(), out.begin(), inDouble);
        }
        return out;
    }
    std::vector<std::vector<Hit>> all() const {
        std::vector<std::vector<Hit>> out(m_rays.size());
        if (m_precise) {
            each([&](std::size_t i) { out[i] = intersectAllReference(m_surface, m_rays[i], m_options); });
        } else {
            std::vector<std::vector<surface::RayHit<float>>> hits(m_rays.size());
            intersectAll(m_surface, m_near, m_options, hits);
            for (std::size_t i = 0; i < hits.size(); ++i)
                std::transform(hits[i].begin(), hits[i].end(), std::back_inserter(out[i]), inDouble);
        }
        return out;
    }
    std::vector<std::uint8_t> any() const {
        std::vector<std::uint8_t> out(m_rays.size());
        if (m_precise)
            each([&](std::size_t i) { out[i] = intersectAnyReference(m_surface, m_rays[i], m_options) ? 1 : 0; });
        else
            intersectAny(m_surface, m_near, m_options, out);
        return out;
    }

  private:
    template <class Body>
    void each(const Body& body) const {
        base::parallelFor(m_rays.size(), 16, body);
    }

    const Surface& m_surface;
    std::span<const base::Rayd> m_rays;
    std::vector<base::Rayf> m_near;
    surface::IntersectOptions m_options;
    bool m_precise;
};

void write(CsvWriter& csv, const Hit& hit, const Vec3d& origin) {
    csv.number(hit.t).place(hit.position + origin).vector(hit.normal);
    csv.endRow();
}

void writeFirst(CsvWriter& csv, const Hit& hit, const Vec3d& origin) {
    csv.integer(hit.hit ? 1 : 0);
    if (hit.hit)
        return write(csv, hit, origin);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    csv.number(nan).vector({nan, nan, nan}).vector({nan, nan, nan});
    csv.endRow();
}

/// Rows of a batch whose first ray has the number `begin`.
template <class Surface>
void writeBatch(CsvWriter& csv, const Batch<Surface>& batch, const std::string& hits, std::size_t begin,
                const Vec3d& origin) {
    if (hits == "first") {
        for (const Hit& hit : batch.first())
            writeFirst(csv, hit, origin);
    } else if (hits == "any") {
        for (const std::uint8_t hit : batch.any()) {
            csv.integer(hit);
            csv.endRow();
        }
    } else {
        for (const std::vector<Hit>& ofRay : batch.all()) {
            for (const Hit& hit : ofRay) {
                csv.integer(static_cast<long long>(begin));
                write(csv, hit, origin);
            }
            ++begin;
        }
    }
}

const char* headerOf(const std::string& hits) {
    if (hits == "any")
        return "hit\n";
    return hits == "all" ? "ray,t,x,y,z,nx,ny,nz\n" : "hit,t,x,y,z,nx,ny,nz\n";
}

void runIntersect(const IntersectArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}});
    requireInputsKept({{"-o", options.out}}, {options.model, options.rays});
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    std::vector<base::Rayd> rays = readRays(io::FileBytes(options.rays), progress);
    openModel(context, options.model, options.surface->parameters(), console);
    const Vec3d origin = document.provenance().origin;
    for (base::Rayd& ray : rays)
        ray.origin -= origin;

    const surface::Surface surface = process::shownAs(document.surface(), progress); // a curve's tube
    const auto byCells = cells::CellSurface::of(surface);
    const auto complex = complexes::Complex::of(surface);
    io::SafeFile file(options.out);
    CsvWriter csv(options.surface->inDouble(), origin);
    file.write(headerOf(options.hits));
    surface::IntersectOptions how;
    how.robust = options.policy == "robust";
    for (std::size_t begin = 0; begin < rays.size(); begin += batchSize) {
        progress.step(static_cast<double>(begin) / static_cast<double>(rays.size()), "Intersecting");
        const auto some = std::span(rays).subspan(begin, std::min(batchSize, rays.size() - begin));
        if (complex)
            writeBatch(csv, Batch(*complex, some, how, options.surface->inDouble()), options.hits, begin, origin);
        else if (byCells)
            writeBatch(csv, Batch(*byCells, some, how, options.surface->inDouble()), options.hits, begin, origin);
        else
            writeBatch(csv, Batch(surface, some, how, options.surface->inDouble()), options.hits, begin, origin);
        file.write(csv.take());
    }
    file.commit();
}

} // namespace

Action addIntersect(OptionSet command) {
    auto options = std::make_shared<IntersectArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("--rays", options->rays, "text file with the header ox,oy,oz,dx,dy,dz, in model units")
        .typeName("RAYS.csv")
        .required();
    command
        .add("-o,--output", options->out,
             "CSV file to write: hit,t,x,y,z,nx,ny,nz with t in model units and the normal pointing against the "
             "ray; a miss has hit 0 and nan in the other columns")
        .typeName("HITS.csv")
        .required();
    command
        .add("--hits", options->hits,
             "first: one row per ray; any: only the column hit, for shadows (a start on the surface does not count "
             "as a hit); all: one row per hit along each ray, ray,t,x,y,z,nx,ny,nz with rays counted from 0")
        .check(oneOf({"first", "any", "all"}))
        .showDefault();
    command
        .add("--policy", options->policy,
             "fast: iterate from the surfels' discs, march where that is doubtful; robust: always march")
        .check(oneOf({"fast", "robust"}))
        .showDefault();
    options->surface = addSurfaceOptions(command, true);
    return [options](Console& console) { runIntersect(*options, console); };
}

} // namespace app
