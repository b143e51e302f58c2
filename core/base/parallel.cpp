#include "core/base/parallel.h"

#include <algorithm>
#include <memory>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <thread>

namespace base {

namespace {
struct Limit {
    int threads = std::max(1u, std::thread::hardware_concurrency());
    std::unique_ptr<tbb::global_control> control;
};
Limit& limit() {
    static Limit instance;
    return instance;
}
} // namespace

void setThreadCount(int threads) {
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    limit().threads = threads <= 0 ? cores : std::min(threads, cores);
    limit().control.reset();
    limit().control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                            static_cast<std::size_t>(limit().threads));
}

int threadCount() {
    return limit().threads;
}

void parallelChunks(std::size_t n, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t, std::size_t)>& body) {
    const std::size_t chunks = chunkCount(n, grain);
    const auto one = [&](std::size_t chunk) { body(chunk * grain, std::min(n, (chunk + 1) * grain), chunk); };
    if (chunks < 2 || threadCount() == 1) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
            one(chunk);
        return;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1), [&](const auto& range) {
        for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk)
            one(chunk);
    });
}

} // namespace base
