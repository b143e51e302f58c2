// Rows of text made in parallel and written in order: the second half of the text writers.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/io/safe_file.h"

#include <algorithm>
#include <vector>

namespace io {

/// Writes what `appendRow(text, i)` appends for i in [0, n), with progress.
template <class AppendRow>
void writeRows(SafeFile& file, std::size_t n, const base::Progress& progress, const AppendRow& appendRow) {
    constexpr std::size_t grain = 4096, chunks = 16;
    std::vector<std::string> parts(chunks);
    for (std::size_t first = 0; first < n; first += grain * chunks) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), "Writing");
        const std::size_t rows = std::min(grain * chunks, n - first);
        base::parallelChunks(rows, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            parts[chunk].clear();
            for (std::size_t i = first + begin; i < first + end; ++i)
                appendRow(parts[chunk], i);
        });
        for (std::size_t chunk = 0; chunk < base::chunkCount(rows, grain); ++chunk)
            file.write(parts[chunk]);
    }
    progress.step(1, "Writing");
}

} // namespace io
