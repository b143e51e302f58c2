// One dab of each tool with 1k, 10k and 50k surfels under the brush, on models of 100k and 1M, with and without
// resampling, and in a stroke; items are the surfels under the brush. The naive way stands beside the tools in the
// table of workloads (workloads_bench.cpp).
#include "app/bench/plain_dab.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/contact.h"
#include "core/sculpt/sampling.h"
#include "core/sculpt/stroke/stroke.h"

#include <benchmark/benchmark.h>
#include <cmath>
#include <map>
#include <numbers>

using base::Vec3d, base::Vec3f;

namespace {

surfel::SurfelList sphere(std::size_t count) {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = layout->colours = true;
    list.layout = layout;
    const double support = std::sqrt(4 * 38 / double(count));
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - (2 * double(i) + 1) / double(count), r = std::sqrt(1 - z * z);
        const double angle = double(i) * std::numbers::pi * (3 - std::sqrt(5.0));
        surfel::Surfel s;
        s.position = s.normal = base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), z});
        s.support = float(support);
        list.items.push_back(s);
    }
    return list;
}

const surface::Surface& model(std::size_t count) {
    static std::map<std::size_t, surface::Surface> made;
    auto& slot = made[count];
    if (slot.tree().empty())
        slot = {tree::SurfelTree::build(sphere(count)), {}};
    return slot;
}

/// Radius whose cap of the sphere holds `under` of `count` surfels: pi R^2 / 4 pi = under / count.
float radiusOf(std::size_t count, std::size_t under) {
    return 2 * std::sqrt(float(under) / float(count));
}

/// Contacts wander so that neither caches nor the shape wear in: every dab starts from the untouched model.
Vec3f wander(int k) {
    const double a = 0.7 * k, b = 0.4 + 0.3 * std::sin(0.31 * k);
    return base::cast<float>(Vec3d{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)});
}

void dab(benchmark::State& state, const sculpt::ToolRow& row, bool resampled) {
    const auto count = std::size_t(state.range(0)), under = std::size_t(state.range(1));
    const surface::Surface& start = model(count);
    const float radius = radiusOf(count, under);
    int k = 0;
    for (auto _ : state) {
        surfel::Surfel at;
        at.position = at.normal = wander(k++);
        const sculpt::Dab dab = bench::plainDab(row, at, radius);
        const tree::Edit edit = row.apply(start, dab);
        surface::Surface next(start.tree().apply(edit), start.definition());
        if (resampled) {
            sculpt::Sampling sampling;
            sampling.start(start, dab.centre);
            sampling.note(start.tree(), edit, dab);
            next = sampling.resample(next);
        }
        benchmark::DoNotOptimize(next);
    }
    state.SetItemsProcessed(state.iterations() * state.range(1));
}

/// A whole dab of a stroke: contact, area, tool, tree, resampling when due.
void strokeDab(benchmark::State& state, const char* tool) {
    const auto count = std::size_t(state.range(0)), under = std::size_t(state.range(1));
    sculpt::StrokeSettings settings;
    settings.tool = tool;
    settings.radius = radiusOf(count, under);
    std::int64_t dabs = 0;
    for (auto _ : state) {
        sculpt::Stroke stroke(model(count), settings);
        for (int k = 0; k <= 10; ++k)
            stroke.add({{{0.3f - 0.1f * settings.radius * float(k), 0.1f, 4}, {0, 0, -1}}, 1, 0});
        stroke.finish();
        dabs += stroke.dabs();
    }
    state.SetItemsProcessed(dabs * state.range(1));
}

void sizes(benchmark::internal::Benchmark* b) {
    for (const int count : {100000, 1000000})
        for (const int under : {1000, 10000, 50000})
            b->Args({count, under});
    b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime()->MinTime(0.2);
}

const bool registered = [] {
    for (const sculpt::ToolRow& row : sculpt::toolTable()) {
        if (row.needs.layer)
            continue;
        const std::string name = std::string("dab-") + row.id;
        sizes(benchmark::RegisterBenchmark(name.c_str(), dab, row, false));
        sizes(benchmark::RegisterBenchmark((name + "-resampled").c_str(), dab, row, true));
        sizes(benchmark::RegisterBenchmark((name + "-in-stroke").c_str(), strokeDab, row.id));
    }
    return true;
}();

} // namespace
