// 3MF: one object, in millimetres as slicers take numbers without a unit, with the colours of its vertices as a colour
// group (3MF Materials and Properties).
#include "core/io/mesh_writers.h"
#include "core/io/number_text.h"
#include "core/io/packed/zip_archive.h"

#include <algorithm>
#include <cstdio>

namespace io {

namespace {

constexpr const char* types = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr const char* relations = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="rel0" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
constexpr const char* modelHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">
<resources>
)";

void entry(ZipWriter& zip, const std::string& name, std::string_view text) {
    zip.begin(name);
    zip.write(text);
    zip.end();
}

/// Writes text as it comes, in pieces that are worth packing, with progress.
template <class Line>
void lines(ZipWriter& zip, std::size_t count, const base::Progress& progress, const Line& line) {
    constexpr std::size_t block = 1 << 14;
    for (std::size_t first = 0; first < count; first += block) {
        progress.step(static_cast<double>(first) / static_cast<double>(count), "Writing");
        std::string text;
        for (std::size_t i = first; i < std::min(count, first + block); ++i)
            line(text, i);
        zip.write(text);
    }
}

void attribute(std::string& text, const char* name, auto value) {
    appendNumber(text.append(" ").append(name).append("=\""), value);
    text += '"';
}

/// The different colours, sorted.
std::vector<surfel::Colour> palette(const mesh::Mesh& mesh) {
    std::vector<surfel::Colour> out = mesh.colours;
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

} // namespace

void writeMesh3mf(const path& target, const mesh::Mesh& mesh, const base::Vec3d& origin,
                  const base::Progress& progress) {
    SafeFile file(target);
    ZipWriter zip(file);
    entry(zip, "[Content_Types].xml", types);
    entry(zip, "_rels/.rels", relations);
    zip.begin("3D/3dmodel.model");
    zip.write(modelHead);
    const std::vector<surfel::Colour> colours = palette(mesh);
    const auto property = [&](std::uint32_t v) {
        return static_cast<std::int64_t>(std::lower_bound(colours.begin(), colours.end(), mesh.colours[v]) -
                                         colours.begin());
    };
    if (!colours.empty()) {
        zip.write("<m:colorgroup id=\"2\">\n");
        lines(zip, colours.size(), progress, [&](std::string& text, std::size_t i) {
            const surfel::Colour c = colours[i];
            char hex[16];
            std::snprintf(hex, sizeof hex, "#%02X%02X%02X%02X", c & 255, c >> 8 & 255, c >> 16 & 255, c >> 24);
            text.append("<m:color color=\"").append(hex).append("\"/>\n");
        });
        zip.write("</m:colorgroup>\n");
    }
    zip.write(colours.empty() ? "<object id=\"1\" type=\"model\">\n"
                              : "<object id=\"1\" type=\"model\" pid=\"2\" pindex=\"0\">\n");
    zip.write("<mesh>\n<vertices>\n");
    lines(zip, mesh.positions.size(), progress, [&](std::string& text, std::size_t i) {
        const base::Vec3d p = mesh.positions[i] + origin;
        text += "<vertex";
        for (std::size_t k = 0; k < 3; ++k)
            attribute(text, std::array{"x", "y", "z"}[k], p[k]);
        text += "/>\n";
    });
    zip.write("</vertices>\n<triangles>\n");
    lines(zip, mesh.triangles.size(), progress, [&](std::string& text, std::size_t i) {
        text += "<triangle";
        for (std::size_t k = 0; k < 3; ++k)
            attribute(text, std::array{"v1", "v2", "v3"}[k], static_cast<std::int64_t>(mesh.triangles[i][k]));
        if (!colours.empty()) {
            text += " pid=\"2\"";
            for (std::size_t k = 0; k < 3; ++k)
                attribute(text, std::array{"p1", "p2", "p3"}[k], property(mesh.triangles[i][k]));
        }
        text += "/>\n";
    });
    zip.write("</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n</model>\n");
    zip.end();
    zip.finish();
    file.commit();
}

} // namespace io
