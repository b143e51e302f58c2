// load-ply: a binary PLY of 27 bytes per point (position, normal, colour) to surfels, beside reading the bare bytes
// into an array, which is the least that any loader must do. Items are points.
#include "core/base/random.h"
#include "core/io/formats.h"

#include <benchmark/benchmark.h>
#include <fstream>
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
            name == "raw.ply" ? writeRaw(path / name) : io::write(path / name, model());
        return path / name;
    }

  private:
    /// Without alpha and comments: 27 bytes a point, as scanners' own programs write.
    void writeRaw(const std::filesystem::path& to) {
        std::ofstream out(to, std::ios::binary);
        out << "ply\nformat binary_little_endian 1.0\nelement vertex " << points
            << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
               "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
        for (const surfel::Surfel& s : model().points.items) {
            out.write(reinterpret_cast<const char*>(&s.position), 12);
            out.write(reinterpret_cast<const char*>(&s.normal), 12);
            out.write(reinterpret_cast<const char*>(&s.colour), 3);
        }
    }
    io::FileModel m_model;
};

Sample& sample() {
    static Sample instance;
    return instance;
}

void report(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}

void loadPly(benchmark::State& state, const char* name) {
    const auto file = sample().file(name);
    for (auto _ : state)
        benchmark::DoNotOptimize(io::read(file).points.items.data());
    report(state);
}

void baselineBytes(benchmark::State& state) {
    const auto file = sample().file("raw.ply");
    const auto size = std::filesystem::file_size(file);
    for (auto _ : state) {
        const auto bytes = std::make_unique_for_overwrite<char[]>(size);
        std::ifstream(file, std::ios::binary).read(bytes.get(), static_cast<std::streamsize>(size));
        benchmark::DoNotOptimize(bytes.get());
    }
    report(state);
}

void savePly(benchmark::State& state) {
    const io::FileModel& model = sample().model();
    for (auto _ : state)
        io::write(sample().path / "saved.ply", model);
    report(state);
}

} // namespace

BENCHMARK_CAPTURE(loadPly, binary_27_bytes, "raw.ply")->Name("load-ply")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(baselineBytes)->Name("load-ply/baseline-bytes")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(loadPly, text, "points.xyz")->Name("load-xyz")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(savePly)->Name("save-ply")->Unit(benchmark::kMillisecond)->UseRealTime();
