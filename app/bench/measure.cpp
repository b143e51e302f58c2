#include "app/bench/measure.h"

#include <algorithm>
#include <chrono>

namespace bench {

namespace {

constexpr std::size_t wantedRepetitions = 9;

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

/// One of the two sides of a measurement.
struct Side {
    Run run;
    std::vector<Rate> rates;
    std::vector<double> times;
    double spent = 0;

    void repeat(double seconds) {
        rates.push_back(repetition(run, seconds, times));
        spent += rates.back().seconds;
    }
    /// What it measured is dropped, unless it took all the time.
    void warmUp(double slice, double seconds) {
        repeat(0.5 * slice);
        if (spent < seconds)
            rates.clear(), times.clear(), spent = 0;
    }
};

} // namespace

Measurement measure(const Workload& workload, Scene& scene, double seconds, const base::Progress& progress) {
    const auto step = [&](double done) { progress.step(done, workload.name); };
    step(0);
    std::vector<Side> sides{{workload.ours(scene), {}, {}}};
    step(0);
    if (workload.naive)
        if (Run naive = workload.naive(scene))
            sides.push_back({std::move(naive), {}, {}});
    const double slice = seconds / static_cast<double>(wantedRepetitions);
    for (Side& side : sides) {
        step(0);
        side.warmUp(slice, seconds);
    }
    for (std::size_t k = 0; k < wantedRepetitions; ++k)
        for (Side& side : sides) {
            step(static_cast<double>(k) / wantedRepetitions);
            if (side.rates.empty() || side.spent + slice <= 1.001 * seconds)
                side.repeat(slice);
        }
    Measurement out{median(sides[0].rates), {}, {}, {}, sides[0].run.remark()};
    if (workload.awaited)
        out.latency = latencyOf(sides[0].times);
    if (sides.size() > 1) {
        out.baseline = median(sides[1].rates);
        if (workload.awaited)
            out.baselineLatency = latencyOf(sides[1].times);
    }
    return out;
}

} // namespace bench
