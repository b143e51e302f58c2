// What an edit costs the display; frames are workloads of the table (workloads_bench.cpp).
#include "core/base/error.h"
#include "render/render_models.h"
#include "ui/gl/offscreen_renderer.h"

#include <benchmark/benchmark.h>

/// What an edit of 20k surfels costs the display: diff, packing and upload.
static void uploadEdit(benchmark::State& state) {
    try {
        const auto context = render::makeOsMesaContext();
        const render::Current current(*context);
        const render::GlFunctions gl =
            render::GlFunctions::load([&](const char* name) { return context->procAddress(name); });
        render::GlSlots slots(gl);
        const tree::SurfelTree model = test::built(test::torus(1, 0.4, 1'000'000, 1));
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
