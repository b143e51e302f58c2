// The workloads of `pointclay bench` under Google Benchmark: every one at 100k, 1M and 10M points, noise-free, with
// 0.02 % and 0.1 % noise, one and two threads, and its baseline as a row of its own beside them:
//
//     evaluate/points:1M/noise:0.02/threads:2        evaluate/points:1M/noise:0.02/baseline
//
// For example: pointclay_bench --benchmark_filter='^(evaluate|project).*1M.*0.02'
#include "app/bench/workload.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

#include <benchmark/benchmark.h>

namespace {

using bench::Scene;
using bench::SceneOptions;
using bench::Workload;

/// The last one is kept: rows that follow each other share it, and ten million points are too many to keep twice.
Scene& scene(const SceneOptions& options) {
    static SceneOptions of;
    static std::unique_ptr<Scene> kept;
    if (!kept || !(of == options)) {
        kept.reset();
        base::setThreadCount(0);
        kept = std::make_unique<Scene>(options);
        of = options;
    }
    return *kept;
}

void measure(benchmark::State& state, const std::function<bench::Run(Scene&)>& make, const SceneOptions& options,
             int threads) {
    try {
        Scene& on = scene(options);
        base::setThreadCount(threads);
        const bench::Run run = make(on);
        run(); // warms up
        std::size_t items = 0;
        for (auto _ : state)
            items += run();
        state.SetItemsProcessed(static_cast<std::int64_t>(items));
    } catch (const base::Error& error) {
        state.SkipWithError(error.what());
    }
    base::setThreadCount(0);
}

void add(const std::string& name, const std::function<bench::Run(Scene&)>& make, const SceneOptions& options,
         int threads) {
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { measure(state, make, options, threads); })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
    for (const auto& [points, pointsName] : {std::pair(100'000, "100k"), {1'000'000, "1M"}, {10'000'000, "10M"}})
        for (const auto& [noise, noiseName] : {std::pair(0.0, "0"), {0.02, "0.02"}, {0.1, "0.1"}})
            for (const Workload& workload : bench::workloadTable()) {
                const SceneOptions options{static_cast<std::size_t>(points), noise};
                const std::string name = workload.name + "/points:" + pointsName + "/noise:" + noiseName;
                for (const int threads : {1, 2})
                    add(name + "/threads:" + std::to_string(threads), workload.ours, options, threads);
                if (workload.naive)
                    add(name + "/baseline", workload.naive, options, 1);
            }
    return true;
}();

} // namespace
