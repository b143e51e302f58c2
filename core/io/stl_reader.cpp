// STL (3D Systems 1989), ascii and binary: corners that coincide exactly become one point, with the area-weighted
// normal of its triangles. The normals written in the file are not trusted: many programs write zeros.
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/record_points.h"
#include "core/io/text/text_lines.h"
#include "core/io/vertex_weld.h"

#include <algorithm>

namespace io {

namespace {

const char* const cutOff = "the file is damaged or was cut off; fetch it again";
constexpr std::size_t binaryHead = 84, binaryFacet = 50;

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (isBlank(text.front()) || text.front() == '\n'))
        text.remove_prefix(1);
    while (!text.empty() && (isBlank(text.back()) || text.back() == '\n'))
        text.remove_suffix(1);
    return text;
}

/// `text` begins with `word` (lower case), in any case.
bool startsWith(std::string_view text, std::string_view word) {
    return text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) {
               return a == b || (b >= 'A' && b <= 'Z' && a == b - 'A' + 'a');
           });
}

bool holds(std::string_view text, std::string_view word) {
    for (; text.size() >= word.size(); text.remove_prefix(1))
        if (startsWith(text, word))
            return true;
    return false;
}

/// "solid" starts binary files too; those have the exact size that their count says, or zeros in their header.
bool isAscii(const FileBytes& file) {
    const std::string_view bytes = file.bytes();
    if (bytes.size() >= binaryHead &&
        binaryHead + binaryFacet * load<std::uint32_t, false>(bytes.data() + 80) == bytes.size())
        return false;
    return startsWith(trimmed(bytes.substr(0, 512)), "solid") &&
           bytes.substr(0, 512).find('\0') == std::string_view::npos;
}

std::vector<base::Vec3d> binaryCorners(const FileBytes& file, const base::Progress& progress) {
    const std::string_view bytes = file.bytes();
    if (bytes.size() < binaryHead)
        file.fail("is too short for an STL file", cutOff);
    const std::size_t facets = load<std::uint32_t, false>(bytes.data() + 80);
    if (facets > (bytes.size() - binaryHead) / binaryFacet)
        file.fail("promises " + std::to_string(facets) + " triangles, but there are bytes for " +
                      std::to_string((bytes.size() - binaryHead) / binaryFacet),
                  cutOff);
    std::vector<base::Vec3d> corners(3 * facets);
    constexpr std::size_t slab = 1 << 18;
    for (std::size_t first = 0; first < facets; first += slab) {
        progress.step(0.3 * static_cast<double>(first) / static_cast<double>(facets), "Reading");
        base::parallelFor(std::min(slab, facets - first), 4096, [&](std::size_t i) {
            const char* at = bytes.data() + binaryHead + (first + i) * binaryFacet + 12;
            for (std::size_t c = 0; c < 9; ++c)
                corners[3 * (first + i) + c / 3][c % 3] = load<float, false>(at + 4 * c);
        });
    }
    return corners;
}

/// The three numbers of a line "vertex x y z". False where they are not there.
bool takeVertex(std::string_view line, base::Vec3d& out) {
    line.remove_prefix(6);
    for (std::size_t k = 0; k < 3; ++k) {
        line = trimmed(line);
        const char* after = parseNumber(line.data(), line.data() + line.size(), out[k]);
        if (!after)
            return false;
        line.remove_prefix(static_cast<std::size_t>(after - line.data()));
    }
    return true;
}

std::vector<base::Vec3d> asciiCorners(const FileBytes& file, const base::Progress& progress) {
    const TextLines lines(file, 0);
    std::vector<std::vector<base::Vec3d>> parts(lines.chunks());
    const std::size_t fault = lines.run({progress, 0, 0.3}, [&](std::size_t chunk) {
        std::size_t bad = TextLines::none;
        lines.forLines(chunk, [&](std::size_t at, std::string_view line) {
            line = trimmed(line);
            if (!startsWith(line, "vertex") || line.size() == 6 || !isBlank(line[6]))
                return true;
            base::Vec3d corner;
            if (!takeVertex(line, corner))
                bad = at;
            parts[chunk].push_back(corner);
            return bad == TextLines::none;
        });
        return bad;
    });
    if (fault != TextLines::none)
        file.failAt(fault, "a vertex needs three numbers", "correct the line or remove its triangle");
    std::vector<base::Vec3d> corners;
    for (auto& part : parts) {
        corners.insert(corners.end(), part.begin(), part.end());
        part = {};
    }
    const std::string_view bytes = file.bytes();
    const std::string_view tail = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 4096));
    if (corners.size() % 3 != 0 || !holds(tail, "endsolid"))
        file.fail("ends inside the solid", cutOff);
    return corners;
}

RecordTable tableOf(const Welded& welded) {
    RecordTable table;
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
        table.fields.push_back({name, ScalarType::Float64, ScalarType::Float64, table.fields.size() * sizeof(double)});
    double* const out = table.allocateDoubles(welded.points.size(), 6);
    base::parallelFor(welded.points.size(), 4096, [&](std::size_t i) {
        // Made unit here, in double: the areas of small triangles may be below what float can hold.
        const base::Vec3d normal = base::normalized(welded.normals[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            out[6 * i + k] = welded.points[i][k];
            out[6 * i + 3 + k] = normal[k];
        }
    });
    return table;
}

} // namespace

FileModel readStl(const FileBytes& file, const base::Progress& progress, const path&) {
    const bool ascii = isAscii(file);
    const std::vector<base::Vec3d> corners = ascii ? asciiCorners(file, progress) : binaryCorners(file, progress);
    if (corners.empty())
        file.fail("holds no points", "choose a file with at least one triangle");
    if (corners.size() >= std::numeric_limits<std::uint32_t>::max())
        file.fail("holds more than a billion triangles", "split the file");
    progress.step(0.3, "Reading");
    FileModel model;
    model.format = ascii ? "stl ascii" : "stl binary";
    model.faces = corners.size() / 3;
    Welded welded = weldTriangles(corners);
    model.polygons.corners = std::move(welded.corners);
    for (std::size_t end = 3; end <= model.polygons.corners.size(); end += 3)
        model.polygons.ends.push_back(end);
    const RecordTable table = tableOf(welded);
    makePoints(model, file, table, rolesOf(table.fields, false), {}, {progress, 0.7, 1});
    return model;
}

} // namespace io
