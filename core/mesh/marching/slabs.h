// Parallel loops over millions of things that check, now and then, whether somebody wants them to stop.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"

#include <algorithm>

namespace mesh {

/// base::parallelChunks, `chunksAtOnce` of them between two steps of progress. Throws base::Cancelled.
template <class Body>
void parallelSlabs(std::size_t n, std::size_t grain, const base::Progress& progress, const char* what,
                   const Body& body) {
    constexpr std::size_t chunksAtOnce = 16;
    const std::size_t slab = grain * chunksAtOnce;
    for (std::size_t first = 0; first < n; first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), what);
        const std::size_t count = std::min(slab, n - first);
        base::parallelChunks(count, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            body(first + begin, first + end, first / grain + chunk);
        });
    }
}

} // namespace mesh
