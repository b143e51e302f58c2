// LAZ, LAS compressed by LASzip (io/README 2.13): chunks are unpacked side by side, each into a part that grows with
// what its bytes tell, and the parts put together.
#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/io/growing_bytes.h"
#include "core/io/las/las_points.h"
#include "core/io/laz/laz_setup.h"
#include "core/io/readers.h"

#include <algorithm>

namespace io {

namespace {

void unpack(const FileBytes& file, const laz::Setup& setup, const std::vector<laz::Chunk>& chunks, GrowingBytes& out,
            const ProgressSpan& progress) {
    const base::CancelScope scope(progress.progress.cancel);
    const std::size_t together = 2 * static_cast<std::size_t>(base::threadCount());
    for (std::size_t first = 0; first < chunks.size(); first += together) {
        progress.step(static_cast<double>(first) / static_cast<double>(chunks.size()));
        const std::size_t count = std::min(together, chunks.size() - first);
        std::vector<std::string> parts(count);
        std::vector<char> whole(count, 0);
        base::parallelFor(count, 1, [&](std::size_t k) {
            const laz::Chunk& chunk = chunks[first + k];
            whole[k] = laz::unpackChunk(file.bytes().substr(chunk.at, chunk.bytes), setup, chunk.points, parts[k]);
        });
        for (std::size_t k = 0; k < count; ++k) {
            if (!whole[k])
                file.failAtByte(chunks[first + k].at, "a chunk of compressed points is damaged",
                                "the file is damaged or was cut off; fetch it again");
            out.append(parts[k]);
            parts[k] = {};
        }
    }
}

} // namespace

FileModel readLaz(const FileBytes& file, const LasHeader& header, const base::Progress& progress) {
    const laz::Setup setup = laz::parseSetup(file, header);
    const std::vector<laz::Chunk> chunks = laz::chunksOf(file, header, setup);
    GrowingBytes records;
    unpack(file, setup, chunks, records, {progress, 0, 0.8});
    RecordTable table;
    table.data = records.data();
    table.stride = header.stride;
    table.count = records.size() / header.stride;
    return lasPoints(file, header, table, {progress, 0.8, 1});
}

} // namespace io
