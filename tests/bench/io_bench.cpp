// Text in, PLY out; `load-ply` is a workload of the table (workloads_bench.cpp). Items are points.
#include "core/base/random.h"
#include "core/io/formats.h"

#include <benchmark/benchmark.h>
#include <memory>
#include <unistd.h>

namespace {

constexpr std::size_t points = 5'000'000;

/// A generated file that goes away with the program.
struct Sample {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("pointclay_io_bench_" + std::to_string(::getpid()));
    Sample() { std::filesystem::create_directory(path); }
    ~Sample() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    const io::FileModel& model() {
        if (m_model.points.items.empty()) {
            auto layout = std::make_shared<surfel::AttributeLayout>();
            layout->normals = layout->oriented = layout->colours = true;
            m_model.points.layout = layout;
            base::Random random(1);
            for (std::size_t i = 0; i < points; ++i) {
                surfel::Surfel s;
                s.normal = base::cast<float>(random.unitVector());
                s.position = s.normal * 2.0f;
                s.colour = static_cast<surfel::Colour>(random.next());
                m_model.points.items.push_back(s);
            }
        }
        return m_model;
    }
    std::filesystem::path file(const std::string& name) {
        if (!std::filesystem::exists(path / name))
            io::write(path / name, model());
        return path / name;
    }

  private:
    io::FileModel m_model;
};

Sample& sample() {
    static Sample instance;
    return instance;
}

void report(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

void loadXyz(benchmark::State& state) {
    const auto file = sample().file("points.xyz");
    for (auto _ : state)
        benchmark::DoNotOptimize(io::read(file).points.items.data());
    report(state);
}

void savePly(benchmark::State& state) {
    const io::FileModel& model = sample().model();
    for (auto _ : state)
        io::write(sample().path / "saved.ply", model);
    report(state);
}

} // namespace

BENCHMARK(loadXyz)->Name("load-xyz")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(savePly)->Name("save-ply")->Unit(benchmark::kMillisecond)->UseRealTime();
