// Frames of splats at 1280 x 720, at rest and of a view that moves.
#include "app/bench/naive/naive_splats.h"
#include "app/bench/workload.h"
#include "core/render/splats/detail_pacer.h"
#include "core/render/splats/splat_kernels.h"
#include "core/render/splats/splat_scale.h"
#include "ui/gl/backends.h"

#include <chrono>
#include <cstdio>

namespace bench {

namespace {

render::Camera view(Scene& scene) {
    return render::Camera::looking(scene.surface().tree().bounds(), 1280, 720);
}

struct Drawing {
    std::unique_ptr<render::Renderer> renderer;
    render::RenderOptions options;
    render::Camera camera;
    render::Image image;
    render::DetailPacer pacer{0.016};

    Drawing(Scene& scene, const char* backend) : renderer(render::makeRenderer(backend)), camera(view(scene)) {
        options.splatScale = render::splatScaleOf(scene.surface().tree());
    }
};

Run drawing(Scene& scene, const char* backend) {
    auto state = std::make_shared<Drawing>(scene, backend);
    return [&tree = scene.surface().tree(), state] {
        state->renderer->render(tree, state->camera, state->options, state->image);
        keep(state->image);
        return tree.size();
    };
}

/// One frame after the other of a view that circles the model, three degrees apart, as coarse as the budget of a
/// window asks for.
Run moving(Scene& scene, const char* backend) {
    auto state = std::make_shared<Drawing>(scene, backend);
    const auto frame = [&tree = scene.surface().tree(), state] {
        constexpr double sine = 0.052336, cosine = 0.998630;
        const base::Vec3d back = state->camera.eye - state->camera.target;
        state->camera.eye = state->camera.target +
                            base::Vec3d{cosine * back.x + sine * back.z, back.y, cosine * back.z - sine * back.x};
        state->options.detailPx = state->pacer.moving();
        const auto start = std::chrono::steady_clock::now();
        state->renderer->render(tree, state->camera, state->options, state->image);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        state->pacer.drew(state->options.detailPx, taken.count());
        keep(state->image);
        return tree.size();
    };
    const auto detail = [state] {
        char text[32];
        std::snprintf(text, sizeof text, "detail %.1f px", static_cast<double>(state->pacer.moving()));
        return std::string(text);
    };
    return {frame, detail};
}

Run naiveDrawing(Scene& scene) {
    struct State {
        std::vector<surfel::Surfel> surfels;
        render::Camera camera;
        render::Image image;
    };
    auto state = std::make_shared<State>();
    state->surfels = scene.surface().tree().surfels().items;
    state->camera = view(scene);
    return [state, radius = render::splatRadiusOfSupport * render::splatScaleOf(scene.surface().tree())] {
        naiveSplats(state->surfels, radius, state->camera, state->image);
        keep(state->image);
        return state->surfels.size();
    };
}

} // namespace

std::vector<Workload> splatWorkloads() {
    constexpr const char* naiveWay = "a loop of squares into a z-buffer, not blended";
    std::vector<Workload> out;
    const auto add = [&](const char* name, const char* tip, auto ours) {
        out.push_back({name, "surfel", tip, naiveWay, ours, naiveDrawing, true, false});
    };
    add("splat-cpu", "a frame of 1280 x 720 by the renderer for machines without a GPU",
        [](Scene& scene) { return drawing(scene, "cpu"); });
    add("splat-cpu-moving", "the same while the view circles the model, as coarse as 16 ms per frame demand",
        [](Scene& scene) { return moving(scene, "cpu"); });
    add("splat-osmesa", "the frame by OpenGL in software", [](Scene& scene) { return drawing(scene, "osmesa"); });
    add("splat-osmesa-moving", "the same while the view circles the model, as coarse as 16 ms per frame demand",
        [](Scene& scene) { return moving(scene, "osmesa"); });
    return out;
}

} // namespace bench
