// Items per second of a workload and of its baseline, side by side: after a warm-up both are repeated in turns, so that
// whatever slows the machine down slows both, and the median repetition of each counts.
#pragma once

#include "bench/workload.h"

#include <optional>

namespace bench {

struct Rate {
    std::size_t items = 0; ///< of the median repetition
    double seconds = 0;    ///< it took

    double perSecond() const { return static_cast<double>(items) / seconds; }
};

struct Measurement {
    Rate ours;
    std::optional<Rate> baseline;
};

/// Takes about `seconds` for each of the two, longer where three repetitions do. Throws base::Cancelled, base::Error.
Measurement measure(const Workload& workload, Scene& scene, double seconds, const base::Progress& progress = {});

} // namespace bench
