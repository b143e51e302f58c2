// LAS of ASPRS, versions 1.0 to 1.4, point formats 0 to 10 (io/README 2.12). The records are taken where they lie.
#include "core/io/las/las_points.h"
#include "core/io/readers.h"

namespace io {

FileModel readLas(const FileBytes& file, const base::Progress& progress, const path&) {
    progress.step(0, "Reading");
    const LasHeader header = parseLasHeader(file);
    if (header.compressed)
        return readLaz(file, header, progress);
    RecordTable table;
    table.data = file.bytes().data() + header.pointsAt;
    table.stride = header.stride;
    table.count = static_cast<std::size_t>(header.points);
    return lasPoints(file, header, table, {progress, 0.1, 1});
}

} // namespace io
