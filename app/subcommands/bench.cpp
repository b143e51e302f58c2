// pointclay bench: items per second of every workload, with the naive way measured beside it in the same run.
#include "app/bench/measure.h"
#include "app/open_model.h"
#include "app/options/face_options.h"
#include "app/options/option_checks.h"
#include "app/subcommands/subcommand.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/row_of_id.h"
#include "core/io/safe_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace app {

using bench::Measurement;
using bench::Workload;
using nlohmann::ordered_json;

namespace {

struct BenchArguments {
    std::vector<std::string> names;
    std::string model, json;
    GivenParameters faces;
    bench::SceneOptions scene;
    double seconds = 1;
};

std::vector<const Workload*> chosen(const std::vector<std::string>& names) {
    std::vector<const Workload*> out;
    for (const std::string& name : names) {
        out.push_back(bench::findWorkload(name));
        if (!out.back())
            throw UsageError("there is no workload '" + name + "'; choose one of " +
                             base::joinedIds(bench::workloadTable(), &Workload::name));
    }
    if (names.empty())
        for (const Workload& workload : bench::workloadTable())
            out.push_back(&workload);
    return out;
}

std::unique_ptr<bench::Scene> sceneOf(const BenchArguments& options, Console& console) {
    const base::Progress progress = console.progress();
    if (options.model.empty())
        return std::make_unique<bench::Scene>(options.scene, progress);
    session::Document document;
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, options.model, parametersOf(options.faces), console);
    return std::make_unique<bench::Scene>(document.surface());
}

/// 9.61M, with three digits.
std::string shortNumber(double value) {
    constexpr const char* units[] = {"", "k", "M", "G", "T"};
    std::size_t unit = 0;
    for (; std::abs(value) >= 999.5 && unit + 1 < std::size(units); ++unit)
        value /= 1000;
    char text[32];
    std::snprintf(text, sizeof text, "%#.3g", value);
    std::string out = text;
    if (out.ends_with('.'))
        out.pop_back();
    return out + units[unit];
}

/// 0.281 0.534 0.601: the median, the 99th of a hundred and the longest.
std::string milliseconds(const std::optional<bench::Latency>& latency) {
    if (!latency)
        return "-";
    std::string out;
    for (const double seconds : {latency->median, latency->p99, latency->max}) {
        char text[32];
        std::snprintf(text, sizeof text, "%s%.3f", out.empty() ? "" : " ", 1e3 * seconds);
        out += text;
    }
    return out;
}

ordered_json jsonOf(const std::optional<bench::Latency>& latency) {
    if (!latency)
        return nullptr;
    return {{"p50", 1e3 * latency->median},
            {"p95", 1e3 * latency->p95},
            {"p99", 1e3 * latency->p99},
            {"max", 1e3 * latency->max}};
}

/// Ours over the baseline, where both do the same work.
std::string ratioOf(const Workload& workload, const Measurement& found) {
    return found.baseline && workload.sameWork ? shortNumber(found.ours.perSecond() / found.baseline->perSecond())
                                               : "-";
}

std::string rowOf(const Workload& workload, std::size_t points, const Measurement& found) {
    char text[320];
    std::snprintf(text, sizeof text, "%-24s %9s %7d %10s %12s %8s %26s  %s%s%s", workload.name.c_str(),
                  shortNumber(static_cast<double>(points)).c_str(), base::threadCount(),
                  shortNumber(found.ours.perSecond()).c_str(),
                  found.baseline ? shortNumber(found.baseline->perSecond()).c_str() : "-",
                  ratioOf(workload, found).c_str(), milliseconds(found.latency).c_str(), workload.item.c_str(),
                  found.remark.empty() ? "" : ", ", found.remark.c_str());
    return text;
}

ordered_json jsonOf(const Workload& workload, std::size_t points, const Measurement& found) {
    ordered_json out{{"name", workload.name},
                     {"points", points},
                     {"threads", base::threadCount()},
                     {"items", found.ours.items},
                     {"seconds", found.ours.seconds},
                     {"items_per_second", found.ours.perSecond()},
                     {"baseline", nullptr},
                     {"baseline_items_per_second", nullptr},
                     {"ms", jsonOf(found.latency)},
                     {"baseline_ms", jsonOf(found.baselineLatency)},
                     {"same_work", nullptr},
                     {"remark", found.remark}};
    if (found.baseline) {
        out["baseline"] = workload.baseline;
        out["same_work"] = workload.sameWork;
        out["baseline_items_per_second"] = found.baseline->perSecond();
    }
    return out;
}

void runBench(const BenchArguments& options, Console& console) {
    const std::vector<const Workload*> workloads = chosen(options.names);
    const std::unique_ptr<bench::Scene> scene = sceneOf(options, console);
    ordered_json rows = ordered_json::array();
    console.clear();
    std::printf("%-24s %9s %7s %10s %12s %8s %26s  %s\n", "name", "points", "threads", "items/s", "baseline/s", "ratio",
                "ms p50, p99, max", "item");
    for (const Workload* workload : workloads) {
        Measurement found;
        try {
            found = bench::measure(*workload, *scene, options.seconds, console.progress());
        } catch (const base::Error& error) { // what the machine lacks; asked for by name it is a failure
            if (!options.names.empty())
                throw;
            console.tell(workload->name + " skipped: " + error.message());
            continue;
        }
        console.clear();
        std::puts(rowOf(*workload, scene->size(), found).c_str());
        std::fflush(stdout);
        rows.push_back(jsonOf(*workload, scene->size(), found));
    }
    if (!options.json.empty())
        io::writeFile(options.json, rows.dump(2) + "\n");
}

const char* article(const std::string& noun) {
    return std::string("aeiou").find(noun.front()) == std::string::npos ? "a " : "an ";
}

std::string baselineHelp(const Workload& workload) {
    return workload.baseline.empty() ? "none" : (workload.sameWork ? "" : "different work: ") + workload.baseline;
}

std::string namesHelp() {
    std::string out = "what to measure; everything by default. An item is";
    for (const Workload& workload : bench::workloadTable())
        out += "\n  " + workload.name + ": " + article(workload.item) + workload.item + ", " + workload.tip +
               "; baseline: " + baselineHelp(workload);
    return out +
           "\n  Baselines run on one thread; those that do different work have no ratio. Work that somebody waits "
           "for also lists the milliseconds of single runs.";
}

} // namespace

Action addBench(OptionSet command) {
    auto options = std::make_shared<BenchArguments>();
    command.add("WORKLOAD", options->names, namesHelp());
    Option model =
        command.add("--model", options->model, std::string(modelHelp) + "; queries are placed around its surfels")
            .typeName("MODEL");
    command
        .add("--points", options->scene.points,
             "number of surfels on a bumpy closed surface, 20 neighbours in each support")
        .typeName("N")
        .check(between(100, 2e8))
        .showDefault()
        .excludes(model);
    command.add("--noise", options->scene.noisePercent, "noise of the positions, in percent of the surface's radius")
        .typeName("PERCENT")
        .check(between(0, 10))
        .showDefault()
        .excludes(model);
    command.add("--seconds", options->seconds, "time to spend on each workload, and as much on its baseline")
        .check(between(0, 3600))
        .showDefault();
    addFaceOptions(command, options->faces, model);
    command.add("--json", options->json, "also write the results as JSON").typeName("OUT.json");
    return [options](Console& console) { runBench(*options, console); };
}

} // namespace app
