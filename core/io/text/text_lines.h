// A text file cut into chunks of about a megabyte at line ends, for parsing in parallel.
//
// Lines end in LF, CRLF or, where a file has no LF at all, CR. The cuts depend on the text alone, so that results put
// together in the order of chunks are the same at any thread count. Any number of threads may read.
#pragma once

#include "core/base/parallel.h"
#include "core/io/file_bytes.h"
#include "core/io/record_points.h"

#include <algorithm>
#include <limits>

namespace io {

class TextLines {
  public:
    static constexpr std::size_t chunkBytes = std::size_t(1) << 20;

    /// Lines of `file` from the byte `begin` on. The file must outlive the object.
    TextLines(const FileBytes& file, std::size_t begin);

    const FileBytes& file() const { return m_file; }
    std::string_view text() const { return m_file.bytes(); }
    std::size_t begin() const { return m_begin; }
    std::size_t chunks() const { return m_starts.size() - 1; }
    /// Byte at which the chunk's first line starts; the end of the text for chunk chunks().
    std::size_t chunkStart(std::size_t chunk) const { return m_starts[chunk]; }
    /// The line that starts at `offset`, without its end (a CR before LF stays).
    std::string_view lineAt(std::size_t offset) const;
    std::size_t nextLine(std::size_t offset) const;

    /// Calls `body(offset, line)` for the lines of a chunk until it returns false.
    template <class Body>
    void forLines(std::size_t chunk, const Body& body) const {
        const std::size_t end = chunkStart(chunk + 1);
        for (std::size_t at = chunkStart(chunk); at < end;) {
            const std::string_view line = lineAt(at);
            if (!body(at, line))
                return;
            at = std::min(at + line.size() + 1, text().size());
        }
    }

    /// Calls `body(chunk)`, which returns the byte of the first faulty line or `none`, for all chunks in parallel, with
    /// progress in between. Returns the first fault of all, or `none`.
    template <class Body>
    std::size_t run(const ProgressSpan& progress, const Body& body) const {
        for (std::size_t slab = 0; slab < chunks(); slab += slabChunks) {
            progress.step(static_cast<double>(slab) / static_cast<double>(chunks()));
            std::size_t faults[slabChunks];
            std::fill_n(faults, slabChunks, none);
            base::parallelFor(std::min(slabChunks, chunks() - slab), 1,
                              [&](std::size_t k) { faults[k] = body(slab + k); });
            const std::size_t first = *std::min_element(faults, faults + slabChunks);
            if (first != none)
                return first;
        }
        return none;
    }

    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  private:
    static constexpr std::size_t slabChunks = 4; ///< between two looks at the cancel flag, some 20 ms of parsing
    const FileBytes& m_file;
    std::size_t m_begin;
    char m_end = '\n';
    std::vector<std::size_t> m_starts;
};

/// White space within a line; a CR counts.
constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

} // namespace io
