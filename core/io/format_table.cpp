#include "core/base/row_of_id.h"
#include "core/io/content_kind.h"
#include "core/io/file_name.h"
#include "core/io/formats.h"
#include "core/io/mesh_formats.h"
#include "core/io/readers.h"

namespace io {

using base::UpAxis;

static constexpr FormatRow table[] = {
    {"ply", "Polygon file", "ply", UpAxis::Y, readPly, writePly},
    {"xyz", "Points as text", "xyz txt csv pts asc pwn", UpAxis::Y, readText, writeText},
    {"obj", "Wavefront OBJ", "obj", UpAxis::Y, readObj, writeObj},
    {"off", "Object file", "off coff noff cnoff", UpAxis::Y, readOff, nullptr},
    {"stl", "Stereolithography", "stl", UpAxis::Z, readStl, nullptr},
};

std::span<const FormatRow> formatTable() {
    return table;
}

/// Points as text have a line that begins with a number among their first ones, and no zero bytes.
static bool looksLikeText(std::string_view bytes) {
    std::string_view start = bytes.substr(0, 4096);
    if (start.find('\0') != std::string_view::npos)
        return false;
    for (int line = 0; line < 20 && !start.empty(); ++line) {
        const std::size_t first = start.find_first_not_of(" \t");
        if (first != std::string_view::npos &&
            std::string_view("0123456789+-.").find(start[first]) != std::string_view::npos)
            return true;
        start.remove_prefix(std::min(start.find_first_of("\r\n"), start.size() - 1) + 1);
    }
    return false;
}

static std::string knownExtensions(bool writable) {
    std::string out;
    for (const FormatRow& row : table)
        if (writable ? row.write != nullptr : row.read != nullptr)
            out.append(out.empty() ? 0 : 1, ' ').append(row.extensions);
    return out;
}

static const FormatRow& readerOf(const FileBytes& file) {
    const std::string extension = extensionOf(file.path()), kind = contentKind(file);
    if (kind.empty() || kind == "stl")
        refuseUnreadable(file, extension);
    const FormatRow* row = rowOfExtension(table, extension);
    // A content that proves itself is believed more than the name; "stl" proves little, so only without another name.
    if (!kind.empty() && (!row || kind != "stl"))
        row = base::findRow(table, kind);
    if (!row && looksLikeText(file.bytes()))
        row = base::findRow(table, "xyz");
    if (!row || !row->read)
        file.fail("is in no known format", "readable are: " + knownExtensions(false));
    return *row;
}

FileModel read(const FileBytes& file, const base::Progress& progress, const std::filesystem::path& folder) {
    const FormatRow& row = readerOf(file);
    FileModel out = row.read(file, progress, folder);
    out.usualUp = row.up;
    return out;
}

FileModel read(const path& path, const base::Progress& progress, const std::filesystem::path& folder) {
    return read(FileBytes(path), progress, folder.empty() ? path.parent_path() : folder);
}

void write(const path& path, const FileModel& model, const base::Progress& progress) {
    const FormatRow* row = rowOfExtension(table, extensionOf(path));
    if ((!row || !row->write) && meshFormatOf(path))
        throw base::Error("holds faces, which a model of points has none of", path.string(),
                          "make them with pointclay mesh, or choose one of the extensions " + knownExtensions(true));
    if (!row || !row->write)
        throw base::Error("cannot be written in this format", path.string(),
                          "choose one of the extensions " + knownExtensions(true));
    row->write(path, model, progress);
}

} // namespace io
