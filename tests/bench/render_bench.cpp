// Splat frames of 1280 x 720 (BUDGETS P8): our tiles on the CPU, with the three GL passes on llvmpipe beside them as
// the baseline. Items are surfels of the model per second; the time per iteration is the frame.
#include "core/base/error.h"
#include "render/render_models.h"
#include "ui/render/cpu_splatter.h"
#include "ui/render/offscreen_renderer.h"

#include <benchmark/benchmark.h>
#include <map>

/// Kept between benchmarks: building 10M surfels takes longer than drawing them.
static const tree::SurfelTree& torusOf(std::size_t count) {
    static std::map<std::size_t, tree::SurfelTree> models;
    tree::SurfelTree& model = models[count];
    if (model.empty())
        model = test::built(test::torus(1, 0.4, count, 1));
    return model;
}

static render::Camera camera(const tree::SurfelTree& model) {
    return render::Camera::looking(model.bounds(), 1280, 720);
}

static void frames(benchmark::State& state, render::Renderer& renderer) {
    const tree::SurfelTree& model = torusOf(static_cast<std::size_t>(state.range(0)));
    const render::Camera view = camera(model);
    render::Image image;
    renderer.render(model, view, {}, image); // the first frame uploads
    for (auto _ : state) {
        renderer.render(model, view, {}, image);
        benchmark::DoNotOptimize(image.colour.data());
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(model.size()));
}

static void splatCpu(benchmark::State& state) {
    render::CpuSplatter renderer;
    frames(state, renderer);
}
BENCHMARK(splatCpu)
    ->Name("splat-cpu")
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Arg(10'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

static void splatOsmesa(benchmark::State& state) {
    try {
        render::OffscreenRenderer renderer(render::makeOsMesaContext());
        frames(state, renderer);
    } catch (const base::Error& e) {
        state.SkipWithError(e.what());
    }
}
BENCHMARK(splatOsmesa)
    ->Name("splat-osmesa")
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// What an edit of 20k surfels costs the display: diff, packing and upload.
static void uploadEdit(benchmark::State& state) {
    try {
        const auto context = render::makeOsMesaContext();
        const render::Current current(*context);
        const render::GlFunctions gl =
            render::GlFunctions::load([&](const char* name) { return context->procAddress(name); });
        render::GlSlots slots(gl);
        const tree::SurfelTree& model = torusOf(1'000'000);
        tree::Edit edit;
        model.forBlocksInBall({1.4f, 0, 0}, 0.27f, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            auto changed = block.clone();
            changed->seal();
            edit.blocks.push_back({number, changed, {}});
        });
        const tree::SurfelTree edited = model.apply(edit);
        slots.show(model);
        bool forth = true;
        std::size_t bytes = 0;
        for (auto _ : state) {
            slots.show(forth ? edited : model);
            bytes += slots.uploadedBytes();
            forth = !forth;
        }
        state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
        state.counters["surfels"] = static_cast<double>(edit.blocks.size() * 112);
        state.counters["calls"] = static_cast<double>(slots.uploads());
    } catch (const base::Error& e) {
        state.SkipWithError(e.what());
    }
}
BENCHMARK(uploadEdit)->Name("upload-edit")->Unit(benchmark::kMillisecond);
