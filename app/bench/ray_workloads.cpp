// First hits of rays (BUDGETS P3).
#include "app/bench/batches.h"
#include "app/bench/naive_surface.h"
#include "app/bench/workload.h"
#include "core/surface/rays/intersect.h"

namespace bench {

using base::Rayf;

namespace {

constexpr std::size_t batchSize = 16384, naiveBatch = 256;
/// Naive rays are taken this far apart, so that some of them are like all of them.
constexpr std::size_t stride = 40503;

Run casting(Scene& scene, std::span<const Rayf> rays) {
    return [&surface = scene.surface(), batches = Batches<Rayf>(rays, batchSize),
            out = std::vector<surface::RayHit<float>>(std::min(batchSize, rays.size()))]() mutable {
        intersect(surface, batches.next(), {}, out);
        keep(out);
        return out.size();
    };
}

Run naiveCasting(Scene& scene, std::span<const Rayf> rays) {
    if (!NaiveSurface::speaks(scene.surface()))
        return {};
    return [&naive = scene.naive(), rays, at = std::size_t(0)]() mutable {
        for (std::size_t i = 0; i < naiveBatch; ++i) {
            at = (at + stride) % rays.size();
            keep(naive.intersect({base::cast<double>(rays[at].origin), base::cast<double>(rays[at].direction)}));
        }
        return naiveBatch;
    };
}

} // namespace

std::vector<Workload> rayWorkloads() {
    constexpr const char* naiveWay = "nanoflann, Eigen double, marching";
    return {
        {"rays-camera", "ray", "first hit of a view's rays, row by row", naiveWay,
         [](Scene& scene) { return casting(scene, scene.cameraRays()); },
         [](Scene& scene) { return naiveCasting(scene, scene.cameraRays()); }},
        {"rays-random", "ray", "first hit of rays from all sides", naiveWay,
         [](Scene& scene) { return casting(scene, scene.randomRays()); },
         [](Scene& scene) { return naiveCasting(scene, scene.randomRays()); }},
    };
}

} // namespace bench
