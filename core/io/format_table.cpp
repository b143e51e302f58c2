#include "core/base/listed.h"
#include "core/base/row_of_id.h"
#include "core/io/before_writing.h"
#include "core/io/content_kind.h"
#include "core/io/file_name.h"
#include "core/io/formats.h"
#include "core/io/las/las_points.h"
#include "core/io/mesh_formats.h"
#include "core/io/packed/gzip.h"
#include "core/io/readers.h"
#include "core/io/record_table.h"

#include <algorithm>
#include <sstream>

namespace io {

using base::UpAxis;

static const char* everything(std::string_view) {
    return "normals colours alpha supports masks definition elements attributes up las-grid";
}

static const char* allOfPoints(std::string_view) {
    return "normals colours alpha supports masks attributes";
}

static const char* heldByLas(std::string_view) {
    return "normals colours supports masks attributes las_records las-grid";
}

static const char* normalsAndColours(std::string_view) {
    return "normals colours";
}

static const char* heldByE57(std::string_view) {
    return "normals colours supports masks attributes";
}

static const char* heldByGltf(std::string_view) {
    return "normals colours alpha supports masks short-attributes";
}

static const char* heldByText(std::string_view extension) {
    return extension == "xyz"   ? "normals colours"
           : extension == "pwn" ? "normals"
           : extension == "pts" ? "colours intensity"
                                : allOfPoints(extension);
}

static constexpr FormatRow table[] = {
    {"ply", "Polygon file", "ply", UpAxis::Y, readPly, writePly, everything},
    {"xyz", "Points as text", "xyz txt csv pts asc pwn", UpAxis::Y, readText, writeText, heldByText},
    {"obj", "Wavefront OBJ", "obj", UpAxis::Y, readObj, writeObj, normalsAndColours},
    {"off", "Object file", "off coff noff cnoff", UpAxis::Y, readOff, nullptr, nullptr},
    {"stl", "Stereolithography", "stl", UpAxis::Z, readStl, nullptr, nullptr},
    {"pcd", "Point Cloud Library", "pcd", UpAxis::Z, readPcd, writePcd, allOfPoints},
    {"las", "ASPRS LAS", "las", UpAxis::Z, readLas, writeLas, heldByLas},
    {"laz", "LASzip LAZ", "laz", UpAxis::Z, readLas, writeLaz, heldByLas},
    {"ptx", "Leica PTX", "ptx", UpAxis::Z, readPtx, nullptr, nullptr},
    {"gltf", "glTF", "glb gltf", UpAxis::Y, readGltf, writeGltf, heldByGltf},
    {"3mf", "3D Manufacturing Format", "3mf", UpAxis::Z, read3mf, nullptr, nullptr},
    {"e57", "ASTM E57", "e57", UpAxis::Z, readE57, writeE57, heldByE57},
};

std::span<const FormatRow> formatTable() {
    return table;
}

/// Points as text have a line that begins with a number, perhaps in quotes, among their first ones, and no zero bytes.
static bool looksLikeText(std::string_view bytes) {
    std::string_view start = bytes.substr(0, 4096);
    if (start.find('\0') != std::string_view::npos)
        return false;
    for (int line = 0; line < 20 && !start.empty(); ++line) {
        const std::size_t first = start.find_first_not_of(" \t\"");
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

static FileModel readPlain(const FileBytes& file, const base::Progress& progress, const path& folder) {
    const FormatRow& row = readerOf(file);
    FileModel out = row.read(file, progress, folder);
    out.usualUp = row.up;
    return out;
}

FileModel read(const FileBytes& file, const base::Progress& progress, const std::filesystem::path& folder) {
    return isGzip(file) ? readPlain(unpackedGzip(file, progress), progress, folder) : readPlain(file, progress, folder);
}

FileModel read(const path& path, const base::Progress& progress, const std::filesystem::path& folder) {
    return read(FileBytes(path), progress, folder.empty() ? path.parent_path() : folder);
}

bool isText(const FileBytes& file) {
    return readerOf(file).read == readText;
}

/// Throws where there is none.
static const FormatRow& writerOf(const path& path) {
    const FormatRow* row = rowOfExtension(table, extensionOf(path));
    if ((!row || !row->write) && meshFormatOf(path))
        throw base::Error("holds faces, which a model of points has none of", path.string(),
                          "make them with pointclay mesh, or choose one of the extensions " + knownExtensions(true));
    if (!row || !row->write)
        throw base::Error("cannot be written in this format", path.string(),
                          "choose one of the extensions " + knownExtensions(true));
    return *row;
}

void requireModelFormat(const path& target) {
    writerOf(target);
}

void write(const path& path, const FileModel& model, const base::Progress& progress) {
    writerOf(path).write(path, model, progress);
}

/// Of no more than 16 bits, or a float.
static bool isShort(surfel::ScalarType type) {
    return type == surfel::ScalarType::Float32 || sizeOf(type) <= 2;
}

/// "other" of "element other 2\n...".
static std::string nameOf(const OpaqueElement& element) {
    std::istringstream words(element.declaration);
    std::string name;
    words >> name >> name;
    return name;
}

std::string lossOf(const path& path, const FileModel& model) {
    const std::string extension = extensionOf(path);
    const FormatRow* row = rowOfExtension(table, extension);
    if (!row || !row->holds)
        return {};
    const std::string_view holds = row->holds(extension);
    const surfel::AttributeLayout& layout = *model.points.layout;
    std::vector<std::string> lost;
    const auto ask = [&](bool has, std::string_view word, const std::string& name) {
        if (has && !isAmong(word, holds))
            lost.push_back(name);
    };
    ask(layout.normals, "normals", "the normals");
    ask(layout.colours, "colours", "the colours");
    ask(layout.colours && isAmong("colours", holds) &&
            std::any_of(model.points.items.begin(), model.points.items.end(),
                        [](const surfel::Surfel& s) { return s.colour >> 24 != 255; }),
        "alpha", "the transparency");
    ask(model.hasSupports, "supports", "the support radii");
    ask(layout.masks, "masks", "the masks");
    if (!isAmong("attributes", holds))
        for (const surfel::Attribute& attribute : layout.attributes())
            ask(!isAmong("short-attributes", holds) || !isShort(attribute.type), attribute.name,
                inQuotes(attribute.name));
    ask(model.definition.has_value(), "definition", "the options of the surface");
    for (const OpaqueElement& element : model.elements)
        if (const std::string name = nameOf(element); !isAmong(name, holds))
            ask(true, "elements", "the element " + name);
    ask(model.up && *model.up != row->up, "up", "the axis that is upwards");
    ask(std::any_of(model.comments.begin(), model.comments.end(),
                    [](const std::string& line) { return line.starts_with(lasGridComment); }),
        "las-grid", "the grid of the LAS coordinates");
    return lost.empty() ? std::string() : std::string(row->label) + " cannot hold " + base::listed(lost) + ".";
}

} // namespace io
