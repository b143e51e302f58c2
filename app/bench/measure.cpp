#include "app/bench/measure.h"

#include <algorithm>
#include <chrono>

namespace bench {

namespace {

constexpr std::size_t wantedRepetitions = 9, leastRepetitions = 3;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs until `seconds` are over, once at least; each run's own time is added to `runs`.
Rate repetition(const Run& run, double seconds, std::vector<double>& runs) {
    Rate out;
    const auto start = Clock::now();
    do {
        const double begin = out.seconds;
        out.items += run();
        out.seconds = secondsSince(start);
        runs.push_back(out.seconds - begin);
    } while (out.seconds < seconds);
    return out;
}

Latency latencyOf(std::vector<double> runs) {
    std::ranges::sort(runs);
    return {runs[runs.size() / 2], runs[runs.size() * 95 / 100], runs[runs.size() * 99 / 100], runs.back()};
}

Rate median(std::vector<Rate> rates) {
    std::ranges::sort(rates, {}, &Rate::perSecond);
    return rates[rates.size() / 2];
}

} // namespace

Measurement measure(const Workload& workload, Scene& scene, double seconds, const base::Progress& progress) {
    const auto step = [&](double done) { progress.step(done, workload.name); };
    step(0);
    std::vector<Run> runs{workload.ours(scene)};
    step(0);
    if (workload.naive)
        if (Run naive = workload.naive(scene))
            runs.push_back(std::move(naive));
    const double slice = seconds / static_cast<double>(wantedRepetitions);
    std::vector<std::vector<Rate>> rates(runs.size());
    std::vector<std::vector<double>> times(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        step(0);
        repetition(runs[i], 0.5 * slice, times[i]); // warms up
        times[i].clear();
    }
    const auto start = Clock::now();
    const double wanted = seconds * static_cast<double>(runs.size());
    for (std::size_t k = 0; k < wantedRepetitions && (k < leastRepetitions || secondsSince(start) < wanted); ++k)
        for (std::size_t i = 0; i < runs.size(); ++i) {
            step(std::min(1.0, secondsSince(start) / wanted));
            rates[i].push_back(repetition(runs[i], slice, times[i]));
        }
    Measurement out{median(rates[0]), {}, {}, {}};
    if (workload.awaited)
        out.latency = latencyOf(times[0]);
    if (rates.size() > 1) {
        out.baseline = median(rates[1]);
        if (workload.awaited)
            out.baselineLatency = latencyOf(times[1]);
    }
    return out;
}

} // namespace bench
