// Progress and cancellation of long work, passed down by value-like reference; default-constructed it reports to
// nobody.
//
// The worker calls `step` now and then from its own thread; whoever started it sets `cancel` from any thread.
#pragma once

#include "core/base/error.h"

#include <atomic>
#include <functional>
#include <string_view>

namespace base {

struct Progress {
    /// Share of the work done, 0 to 1, and what is being done. Called on the worker's thread.
    std::function<void(double, std::string_view)> report;
    /// Set by the owner to stop the work; may be null. Outlives the work.
    const std::atomic<bool>* cancel = nullptr;

    /// Reports and throws Cancelled where asked to stop. Call it at least every 50 ms of work.
    void step(double done, std::string_view what) const {
        if (cancel && cancel->load(std::memory_order_relaxed))
            throw Cancelled();
        if (report)
            report(done, what);
    }
};

} // namespace base
