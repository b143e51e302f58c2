// Items per second of a workload and of its baseline, side by side: after a warm-up both are repeated in turns, so that
// whatever slows the machine down slows both, and the median repetition of each counts. Where a single run takes all
// the time there is, it is the measurement. Where runs are waited for, each is timed as well.
#pragma once

#include "app/bench/workload.h"

#include <optional>

namespace bench {

struct Rate {
    std::size_t items = 0; ///< of the median repetition
    double seconds = 0;    ///< it took

    double perSecond() const { return static_cast<double>(items) / seconds; }
};

/// Of single runs, in seconds.
struct Latency {
    double median = 0, p95 = 0, p99 = 0, max = 0;
};

struct Measurement {
    Rate ours;
    std::optional<Rate> baseline;
    std::optional<Latency> latency, baselineLatency; ///< where the workload is awaited
    std::string remark;                              ///< of ours; empty for none
};

/// Takes about `seconds` for each of the two, and one run more at most. Throws base::Cancelled, base::Error.
Measurement measure(const Workload& workload, Scene& scene, double seconds, const base::Progress& progress = {});

} // namespace bench
