// LAZ: the records of las_writer.h in chunks that LASzip can unpack each by itself (io/README 2.13).
#include "core/base/parallel.h"
#include "core/io/las/las_writer.h"
#include "core/io/laz/laz_setup.h"
#include "core/io/readers.h"
#include "core/io/safe_file.h"

#include <algorithm>

namespace io {

void writeLaz(const path& target, const FileModel& model, const base::Progress& progress) {
    const LasRecords records(model);
    const laz::Setup setup = laz::setupOf(records.layout(), records.stride());
    SafeFile file(target);
    const std::string head = records.header(laz::recordOf(setup), 1, true);
    file.write(head);
    // The table follows the chunks; where it lies stands in the last bytes, as for files that are written in one go.
    file.write(std::string(8, '\xff'));
    std::uint64_t at = head.size() + 8;
    const std::size_t n = model.points.size(), each = setup.chunkPoints, count = (n + each - 1) / each;
    std::vector<laz::Chunk> chunks(count);
    constexpr std::size_t together = 8;
    for (std::size_t first = 0; first < count; first += together) {
        progress.step(static_cast<double>(first) / static_cast<double>(count), "Writing");
        std::vector<std::string> parts(std::min(together, count - first));
        base::parallelFor(parts.size(), 1, [&](std::size_t k) {
            const std::size_t begin = (first + k) * each, end = std::min(n, begin + each);
            std::string bytes((end - begin) * records.stride(), '\0');
            for (std::size_t i = begin; i < end; ++i)
                records.fill(i, bytes.data() + (i - begin) * records.stride());
            parts[k] = laz::packChunk(bytes, setup);
        });
        for (std::size_t k = 0; k < parts.size(); ++k) {
            chunks[first + k].bytes = parts[k].size();
            file.write(parts[k]);
            at += parts[k].size();
        }
    }
    std::string end = laz::chunkTable(chunks);
    end.append(reinterpret_cast<const char*>(&at), sizeof at);
    file.write(end);
    progress.step(1, "Writing");
    file.commit();
}

} // namespace io
