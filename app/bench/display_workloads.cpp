// What an edit of up to 20k surfels costs the display: the tiles drawn again, the blocks uploaded again.
#include "app/bench/workload.h"
#include "core/render/splats/splat_scale.h"
#include "ui/gl/backends.h"
#include "ui/gl/gl_context.h"
#include "ui/gl/gl_slots.h"

#include <array>

namespace bench {

namespace {

/// The model, and the same with the blocks about a place made anew.
struct Versions {
    std::array<tree::SurfelTree, 2> trees;
    std::size_t surfels = 0; ///< that the edit touches

    explicit Versions(Scene& scene) {
        const tree::SurfelTree& model = scene.surface().tree();
        constexpr std::size_t wanted = 20000;
        const base::Vec3f place = scene.places(1)[0].position;
        tree::Edit edit;
        // The radius of the disc that so many evenly spread surfels fill.
        const double part = std::sqrt(std::min(1.0, static_cast<double>(wanted) / static_cast<double>(model.size())));
        const auto radius = static_cast<float>(2 * scene.radius() * part);
        model.forBlocksInBall(place, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            if (surfels > 0 && surfels + static_cast<std::size_t>(block.size()) > wanted)
                return;
            auto changed = block.clone();
            changed->seal();
            surfels += static_cast<std::size_t>(block.size());
            edit.blocks.push_back({number, changed, {}});
        });
        trees = {model, model.apply(edit)};
    }
};

Run redrawing(Scene& scene, bool whole) {
    struct State {
        Versions versions;
        std::unique_ptr<render::Renderer> renderer = render::makeRenderer("cpu");
        render::RenderOptions options;
        render::Camera camera;
        render::Image image;
        std::size_t next = 1;

        explicit State(Scene& model) : versions(model) {}
    };
    auto state = std::make_shared<State>(scene);
    state->options.splatScale = render::splatScaleOf(scene.surface().tree());
    state->camera = render::Camera::looking(scene.surface().tree().bounds(), 1280, 720);
    state->renderer->render(state->versions.trees[0], state->camera, state->options, state->image);
    return [state, whole] {
        const tree::SurfelTree& tree = state->versions.trees[std::exchange(state->next, 1 - state->next)];
        if (whole)
            state->renderer->render(tree, state->camera, state->options, state->image);
        else
            state->renderer->update(tree, state->camera, state->options, state->image);
        keep(state->image);
        return state->versions.surfels;
    };
}

Run uploading(Scene& scene, bool whole) {
    struct State {
        Versions versions;
        std::unique_ptr<render::GlContext> context = render::makeOsMesaContext();
        render::GlFunctions gl;
        std::unique_ptr<render::GlSlots> slots;
        std::size_t next = 1;

        explicit State(Scene& model) : versions(model) {
            const render::Current current(*context);
            gl = render::GlFunctions::load([&](const char* name) { return context->procAddress(name); });
            slots = std::make_unique<render::GlSlots>(gl);
            slots->show(versions.trees[0]);
        }
        ~State() {
            const render::Current current(*context);
            slots.reset();
        }
    };
    auto state = std::make_shared<State>(scene);
    return [state, whole] {
        const render::Current current(*state->context);
        if (whole)
            state->slots->show({});
        state->slots->show(state->versions.trees[std::exchange(state->next, 1 - state->next)]);
        return state->versions.surfels;
    };
}

} // namespace

std::vector<Workload> displayWorkloads() {
    return {
        {"splat-cpu-edit", "surfel", "redraws the part of a frame that an edit of 20k surfels can touch",
         "ours: the whole frame", [](Scene& scene) { return redrawing(scene, false); },
         [](Scene& scene) { return redrawing(scene, true); }, true},
        {"splat-osmesa-upload", "surfel", "uploads an edit of 20k surfels to OpenGL", "ours: the whole model uploaded",
         [](Scene& scene) { return uploading(scene, false); }, [](Scene& scene) { return uploading(scene, true); },
         true},
    };
}

} // namespace bench
