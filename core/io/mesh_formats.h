// The table of formats that triangle meshes are written in; the command line, help and tests are loops over it.
//
// Positions are written in file coordinates, origin + position: doubles in PLY, the shortest decimals that bring back
// the double in text, floats in binary STL. Normals, colours and masks are written where the mesh has them and the
// format can hold them. Writing goes beside the target and is renamed when complete.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <filesystem>
#include <span>
#include <string>

namespace io {

struct MeshFormatRow {
    const char* id;         ///< "ply"
    const char* label;      ///< "Polygon file"
    const char* extensions; ///< separated by blanks, lower case
    const char* holds;      ///< what it keeps beside positions and triangles, for help
    void (*write)(const std::filesystem::path&, const mesh::Mesh&, const base::Vec3d& origin, const base::Progress&);
};

std::span<const MeshFormatRow> meshFormatTable();

/// Null where no format has the name's extension.
const MeshFormatRow* meshFormatOf(const std::filesystem::path& path);
/// "ply obj stl off"
std::string meshExtensions();

/// By extension. Throws base::Error where there is none such, or where the file cannot be written; base::Cancelled.
void writeMesh(const std::filesystem::path& path, const mesh::Mesh& mesh, const base::Vec3d& origin = {},
               const base::Progress& progress = {});

} // namespace io
