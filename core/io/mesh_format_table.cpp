#include "core/base/error.h"
#include "core/io/file_name.h"
#include "core/io/mesh_writers.h"

namespace io {

static constexpr MeshFormatRow table[] = {
    {"ply", "Polygon file", "ply", "normals, colours, masks and further attributes, in doubles", writeMeshPly},
    {"obj", "Wavefront OBJ", "obj", "normals and colours", writeMeshObj},
    {"stl", "Stereolithography", "stl", "nothing; binary, or text where the model lies far from the origin",
     writeMeshStl},
    {"off", "Object file", "off coff noff cnoff", "normals and colours", writeMeshOff},
    {"glb", "glTF", "glb gltf", "normals and colours", writeMeshGltf},
    {"3mf", "3D Manufacturing Format", "3mf", "colours", writeMesh3mf},
};

std::span<const MeshFormatRow> meshFormatTable() {
    return table;
}

const MeshFormatRow* meshFormatOf(const path& file) {
    return rowOfExtension(table, extensionOf(file));
}

std::string meshExtensions() {
    std::string out;
    for (const MeshFormatRow& row : table)
        out.append(out.empty() ? 0 : 1, ' ').append(row.extensions);
    return out;
}

void writeMesh(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress) {
    const MeshFormatRow* row = meshFormatOf(file);
    if (!row)
        throw base::Error("cannot be written as a mesh in this format", file.string(),
                          "choose one of the extensions " + meshExtensions());
    row->write(file, mesh, origin, progress);
}

} // namespace io
