// First hits of rays.
#include "app/bench/batches.h"
#include "app/bench/naive/naive_rays.h"
#include "app/bench/workload.h"
#include "core/surface/rays/intersect.h"

namespace bench {

using base::Rayf;

namespace {

constexpr std::size_t batchSize = 16384, naiveBatch = 256;

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
    return [&naive = scene.naiveRays(), batches = Batches<Rayf>(rays, naiveBatch)]() mutable {
        for (const Rayf& ray : batches.next())
            keep(naive.intersect({base::cast<double>(ray.origin), base::cast<double>(ray.direction)}));
        return batches.size();
    };
}

} // namespace

std::vector<Workload> rayWorkloads() {
    constexpr const char* naiveWay = "Embree oriented discs, Newton steps on nanoflann sums in Eigen double";
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
