// Records of fixed size made in parallel and written in order: the second half of the binary writers of meshes.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/io/safe_file.h"

#include <algorithm>
#include <cstring>

namespace io {

/// Puts values one behind the other, little-endian as the machines we run on are.
class RecordCursor {
  public:
    explicit RecordCursor(char* at) : m_at(at) {}
    template <class T>
    RecordCursor& put(T value) {
        std::memcpy(m_at, &value, sizeof value);
        m_at += sizeof value;
        return *this;
    }

  private:
    char* m_at;
};

/// Writes n records of `stride` bytes, each filled by fill(cursor, i), with progress.
template <class Fill>
void writeRecords(SafeFile& file, std::size_t n, std::size_t stride, const base::Progress& progress, const Fill& fill) {
    constexpr std::size_t grain = 2048, block = 64 * grain;
    std::string buffer(std::min(block, n) * stride, '\0');
    for (std::size_t first = 0; first < n; first += block) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), "Writing");
        const std::size_t rows = std::min(block, n - first);
        base::parallelFor(rows, grain, [&](std::size_t i) {
            RecordCursor cursor(buffer.data() + i * stride);
            fill(cursor, first + i);
        });
        file.write({buffer.data(), rows * stride});
    }
}

} // namespace io
