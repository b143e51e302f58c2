// Binary little-endian PLY (Turk 1994): vertices with all they have, faces as `list uchar int vertex_indices`.
#include "core/io/binary_output.h"
#include "core/io/mesh_writers.h"
#include "core/io/record_roles.h"

namespace io {

static std::string headerOf(const mesh::Mesh& mesh) {
    std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
    if (!mesh.normals.empty())
        out += "property float nx\nproperty float ny\nproperty float nz\n";
    if (!mesh.colours.empty())
        for (const char* name : channelColours)
            out += std::string("property uchar ") + name + "\n";
    if (!mesh.masks.empty())
        out += "property float mask\n";
    return out + "element face " + std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

void writeMeshPly(const path& target, const mesh::Mesh& mesh, const base::Vec3d& origin,
                  const base::Progress& progress) {
    const std::size_t stride = 3 * sizeof(double) + (mesh.normals.empty() ? 0 : 3 * sizeof(float)) +
                               (mesh.colours.empty() ? 0 : 4) + (mesh.masks.empty() ? 0 : sizeof(float));
    SafeFile file(target);
    file.write(headerOf(mesh));
    writeRecords(file, mesh.positions.size(), stride, progress, [&](RecordCursor& out, std::size_t i) {
        const base::Vec3d p = mesh.positions[i] + origin;
        out.put(p.x).put(p.y).put(p.z);
        if (!mesh.normals.empty())
            out.put(mesh.normals[i].x).put(mesh.normals[i].y).put(mesh.normals[i].z);
        if (!mesh.colours.empty())
            out.put(mesh.colours[i]);
        if (!mesh.masks.empty())
            out.put(mesh.masks[i]);
    });
    writeRecords(file, mesh.triangles.size(), 13, progress, [&](RecordCursor& out, std::size_t f) {
        const mesh::Triangle& t = mesh.triangles[f];
        out.put(std::uint8_t(3)).put(t[0]).put(t[1]).put(t[2]);
    });
    file.commit();
}

} // namespace io
