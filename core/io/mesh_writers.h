// The writers behind the rows of the table of mesh formats; see mesh_formats.h for what they promise. Internal to the
// room.
#pragma once

#include "core/io/mesh_formats.h"

namespace io {

using std::filesystem::path;

void writeMeshPly(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress);
void writeMeshObj(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress);
void writeMeshStl(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress);
void writeMeshOff(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress);
void writeMeshGltf(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress);
void writeMesh3mf(const path& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress);

} // namespace io
