#include "core/base/parallel.h"

#include "core/base/cancel_scope.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <thread>
#include <vector>

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

#ifdef __SANITIZE_THREAD__
/// Debian's oneTBB is not built with TSan, which sees none of its synchronisation and calls every hand-over a race.
static void runOnPlainThreads(std::size_t chunks, const std::function<void(std::size_t)>& one) {
    std::atomic<std::size_t> next{0};
    std::mutex guard;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t chunk; (chunk = next++) < chunks;)
            try {
                one(chunk);
            } catch (...) {
                const std::lock_guard lock(guard);
                failure = std::current_exception();
                next = chunks;
            }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threadCount(); ++i)
        others.emplace_back(work);
    work();
    for (std::thread& other : others)
        other.join();
    if (failure)
        std::rethrow_exception(failure);
}
#endif

void parallelChunks(std::size_t n, std::size_t grain,
                    const std::function<void(std::size_t, std::size_t, std::size_t)>& body) {
    const std::size_t chunks = chunkCount(n, grain);
    const auto one = [&, cancel = CancelScope::flag()](std::size_t chunk) {
        const CancelScope scope(cancel); // for loops inside of this one
        CancelScope::check();
        body(chunk * grain, std::min(n, (chunk + 1) * grain), chunk);
    };
    if (chunks < 2 || threadCount() == 1) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
            one(chunk);
        return;
    }
#ifdef __SANITIZE_THREAD__
    runOnPlainThreads(chunks, one);
#else
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1), [&](const auto& range) {
        for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk)
            one(chunk);
    });
#endif
}

} // namespace base
