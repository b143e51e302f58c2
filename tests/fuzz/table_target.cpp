// What `query`, `intersect` and `haptic` read, and their answers on a small model. Which definition follows from the
// length.
#include "app/number_table.h"
#include "core/haptics/proxy.h"
#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "core/session/trajectory_file.h"
#include "core/surface/curvature.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"
#include "fuzz/fuzzed.h"

using base::Vec3d;
using surface::Surface;

namespace {

constexpr std::size_t mostRows = 24;

Surface made(const char* sample, surface::Frame frame, surface::Weight weight) {
    surface::SurfaceDefinition definition;
    definition.frame = frame;
    definition.weight = weight;
    return process::prepare(process::sample(sample).make(150, 1), {definition, false});
}

const Surface& surfaceOf(std::size_t number) {
    using surface::Frame;
    using surface::Weight;
    static const Surface models[] = {
        made("sphere", Frame::Normals, Weight::Wendland),    made("torus", Frame::Hyperplanes, Weight::Gaussian),
        made("sphere", Frame::Covariance, Weight::Wendland), made("sphere", Frame::Apss, Weight::Wendland),
        made("torus", Frame::Rimls, Weight::Wendland),
    };
    return models[number % std::size(models)];
}

void answer(const Surface& surface, std::span<const Vec3d> positions) {
    for (const Vec3d& x : positions) {
        const base::Vec3f near = base::cast<float>(x);
        if (!base::isFinite(near)) // as `query` does
            continue;
        const auto at = surface.evaluate(near, surface::Need::Gradient);
        fuzz::require(!at.ok() || (std::isfinite(at.value) && base::isFinite(at.gradient)), "answers are finite");
        const auto exact = surface.evaluateReference(x, surface::Need::Hessian);
        fuzz::require(!exact.ok() || std::isfinite(exact.value), "exact answers are finite");
        for (const auto projector :
             {surface::Projector::Basic, surface::Projector::Almost, surface::Projector::Orthogonal}) {
            const auto foot = project(surface, near, {projector});
            fuzz::require(!foot.ok() || base::isFinite(foot.foot), "feet are finite");
            static_cast<void>(projectReference(surface, x, {projector}));
        }
        static_cast<void>(curvatureReference(surface, x));
    }
}

void answer(const Surface& surface, std::span<const base::Rayd> rays) {
    for (const base::Rayd& ray : rays) {
        const base::Rayf near{base::cast<float>(ray.origin), base::normalized(base::cast<float>(ray.direction))};
        for (const bool robust : {false, true}) {
            surface::IntersectOptions options;
            options.robust = robust;
            const auto hit = intersect(surface, near, options);
            fuzz::require(!hit.hit || (std::isfinite(hit.t) && base::isFinite(hit.position)), "hits are finite");
            static_cast<void>(intersectAll(surface, near, options));
            static_cast<void>(intersectAny(surface, near, options));
            static_cast<void>(intersectReference(surface, ray, options));
        }
    }
}

void answer(const Surface& surface, std::span<const haptics::TimedPlace> places) {
    for (const double radius : {0.0, 0.1}) {
        haptics::Proxy proxy({radius, 0.3});
        for (const haptics::TimedPlace& at : places) {
            if (!proxy.placed())
                proxy.place(surface, at.place);
            proxy.move(surface, at.place);
            fuzz::require(base::isFinite(proxy.position()) && std::isfinite(proxy.depth()), "proxies are finite");
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const io::FileBytes file("a.csv", std::string(data, data + size));
    fuzz::tried([&] {
        const std::vector<Vec3d> points = app::readPoints(file, {});
        answer(surfaceOf(size), std::span(points).first(std::min(points.size(), mostRows)));
    });
    fuzz::tried([&] {
        const std::vector<base::Rayd> rays = app::readRays(file, {});
        answer(surfaceOf(size), std::span(rays).first(std::min(rays.size(), mostRows)));
    });
    fuzz::tried([&] {
        const haptics::Trajectory places = session::readTrajectory(file, {});
        requireValid(places);
        answer(surfaceOf(size), std::span(places).first(std::min(places.size(), mostRows)));
    });
    return 0;
}
