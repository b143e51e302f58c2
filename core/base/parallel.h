// Parallel loops. oneTBB stays behind this header.
//
// Work is cut into chunks that depend on `n` and `grain` alone, never on the number of threads: combining the results
// of chunks in their order gives the same bits at any thread count. Below two chunks it runs on the caller.
#pragma once

#include <cstddef>
#include <functional>

namespace base {

/// Threads that loops may use, 1 to the number of cores; 0 means all cores. Set before work starts.
void setThreadCount(int threads);
int threadCount();

/// Calls `body(begin, end, chunk)` for the consecutive ranges of `grain` items that make up [0, n). An exception of
/// `body` stops the loop and reaches the caller. REQUIRES: grain >= 1.
void parallelChunks(std::size_t n, std::size_t grain,
                    const std::function<void(std::size_t begin, std::size_t end, std::size_t chunk)>& body);

/// Number of chunks that parallelChunks makes of `n`.
inline std::size_t chunkCount(std::size_t n, std::size_t grain) {
    return (n + grain - 1) / grain;
}

/// Calls `body(i)` for every i in [0, n), `grain` of them in a row on one thread.
template <class Body>
void parallelFor(std::size_t n, std::size_t grain, const Body& body) {
    parallelChunks(n, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i)
            body(i);
    });
}

} // namespace base
