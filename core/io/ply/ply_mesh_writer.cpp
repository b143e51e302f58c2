// Binary little-endian PLY (Turk 1994): vertices with all they have, faces as `list uchar int vertex_indices`.
#include "core/io/binary_output.h"
#include "core/io/mesh_writers.h"
#include "core/io/ply/ply_header.h"
#include "core/io/record_roles.h"
#include "core/io/record_table.h"

namespace io {

static PlyElement vertexElement(const mesh::Mesh& mesh) {
    PlyElement out{"vertex", mesh.positions.size(), {}};
    const auto add = [&](const std::string& name, ScalarType type) {
        PlyProperty property;
        property.name = name;
        property.type = type;
        out.properties.push_back(property);
    };
    for (const char* name : {"x", "y", "z"})
        add(name, ScalarType::Float64);
    if (!mesh.normals.empty())
        for (const char* name : {"nx", "ny", "nz"})
            add(name, ScalarType::Float32);
    if (!mesh.colours.empty())
        for (const char* name : channelColours)
            add(name, ScalarType::UInt8);
    if (!mesh.masks.empty())
        add("mask", ScalarType::Float32);
    if (!mesh.extra.empty())
        for (const surfel::Attribute& attribute : mesh.layout->attributes())
            add(attribute.name, attribute.type);
    return out;
}

static std::string headerOf(const PlyElement& vertices, std::size_t faces) {
    return "ply\nformat binary_little_endian 1.0\n" + vertices.declaration() + "element face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// Words of integers hold them widened: the low bytes are the value.
static void putAttributes(RecordCursor& out, const mesh::Mesh& mesh, std::size_t vertex) {
    const std::uint32_t* words = mesh.extra.data() + vertex * mesh.layout->words();
    for (const surfel::Attribute& attribute : mesh.layout->attributes()) {
        const std::uint32_t* word = words + attribute.firstWord;
        switch (sizeOf(attribute.type)) {
        case 1:
            out.put(static_cast<std::uint8_t>(*word));
            break;
        case 2:
            out.put(static_cast<std::uint16_t>(*word));
            break;
        case 4:
            out.put(*word);
            break;
        default:
            out.put(word[0]).put(word[1]);
        }
    }
}

void writeMeshPly(const path& target, const mesh::Mesh& mesh, const base::Vec3d& origin,
                  const base::Progress& progress) {
    const PlyElement vertices = vertexElement(mesh);
    SafeFile file(target);
    file.write(headerOf(vertices, mesh.triangles.size()));
    writeRecords(file, mesh.positions.size(), vertices.scalarBytes(), progress, [&](RecordCursor& out, std::size_t i) {
        const base::Vec3d p = mesh.positions[i] + origin;
        out.put(p.x).put(p.y).put(p.z);
        if (!mesh.normals.empty())
            out.put(mesh.normals[i].x).put(mesh.normals[i].y).put(mesh.normals[i].z);
        if (!mesh.colours.empty())
            out.put(mesh.colours[i]);
        if (!mesh.masks.empty())
            out.put(mesh.masks[i]);
        if (!mesh.extra.empty())
            putAttributes(out, mesh, i);
    });
    writeRecords(file, mesh.triangles.size(), 13, progress, [&](RecordCursor& out, std::size_t f) {
        const mesh::Triangle& t = mesh.triangles[f];
        out.put(std::uint8_t(3)).put(t[0]).put(t[1]).put(t[2]);
    });
    file.commit();
}

} // namespace io
