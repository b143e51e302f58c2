// Rays for lighting: any hit on the way to a lamp, or nearby.
#include "app/bench/batches.h"
#include "app/bench/workload.h"
#include "core/raycast/blocking.h"
#include "core/raycast/directions.h"

namespace bench {

using base::Rayf;
using base::Vec3f;

namespace {

constexpr std::size_t batchSize = 16384;
constexpr float nearby = 0.25f; ///< reach of occlusion, in diagonals

enum class Ask { Lamp, Sky };

/// Rays of a picture's pixels, one each, that a lamp or the sky may be behind.
struct LightRays {
    std::vector<Rayf> rays;
    surface::IntersectOptions options;

    LightRays(Scene& scene, Ask ask) {
        const auto camera = scene.cameraRays();
        std::vector<surface::RayHit<float>> hits(camera.size());
        intersect(scene.surface(), camera, {}, hits);
        const Vec3f lamp = normalized(Vec3f{0.5f, 0.8f, 0.6f});
        for (std::size_t i = 0; i < hits.size(); ++i) {
            if (!hits[i].hit)
                continue;
            raycast::LightPoint point;
            point.x = hits[i].position, point.n = hits[i].normal, point.unit = hits[i].unit;
            const int pattern = static_cast<int>(i) % raycast::patternCount;
            const Vec3f d = ask == Ask::Lamp ? lamp : around(point.n, raycast::unitSquarePoint(pattern, 0, 1), 1);
            if (dot(d, point.n) > 0)
                rays.push_back({secondaryOrigin(point, point.n), d});
        }
        if (ask == Ask::Sky)
            options.tMax = nearby * scene.surface().tree().bounds().diagonal();
    }
};

/// A run of `cast(surface, rays, options, out)` in batches.
template <class Out, class Cast>
Run casting(Scene& scene, Ask ask, const Cast& cast) {
    struct State {
        LightRays light;
        Batches<Rayf> batches;
        std::vector<Out> out;
        State(Scene& s, Ask a) : light(s, a), batches(light.rays, batchSize), out(batches.size()) {}
    };
    auto state = std::make_shared<State>(scene, ask);
    return [&surface = scene.surface(), state, cast] {
        cast(surface, state->batches.next(), state->light.options, std::span(state->out));
        keep(state->out);
        return state->out.size();
    };
}

Workload asking(const char* name, const char* tip, Ask ask) {
    return {name,
            "ray",
            tip,
            "ours: first hits of the same rays",
            [=](Scene& scene) {
                return casting<std::uint8_t>(scene, ask, [](const auto&... x) { surface::intersectAny(x...); });
            },
            [=](Scene& scene) {
                return casting<surface::RayHit<float>>(scene, ask, [](const auto&... x) { surface::intersect(x...); });
            }};
}

} // namespace

std::vector<Workload> lightWorkloads() {
    return {
        asking("rays-shadow", "any hit between what a view shows and a lamp", Ask::Lamp),
        asking("rays-occlusion", "any hit near what a view shows, in all directions above it", Ask::Sky),
    };
}

} // namespace bench
