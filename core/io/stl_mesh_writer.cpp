// STL (3D Systems 1989): corners and normals of triangles. Binary holds floats, which is too little far from the
// origin: there it is written as text.
#include "core/io/binary_output.h"
#include "core/io/mesh_writers.h"
#include "core/io/number_text.h"
#include "core/io/text/text_output.h"

#include <array>

namespace io {

namespace {

base::Vec3f normalOf(const std::array<base::Vec3d, 3>& corners) {
    return base::cast<float>(base::normalized(cross(corners[1] - corners[0], corners[2] - corners[0])));
}

std::array<base::Vec3d, 3> cornersOf(const mesh::Mesh& mesh, std::size_t f) {
    const mesh::Triangle& t = mesh.triangles[f];
    return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

void writeBinary(SafeFile& file, const mesh::Mesh& mesh, const base::Progress& progress) {
    std::string head = "binary STL by pointclay"; // must not begin with "solid"
    head.resize(80, ' ');
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    head.append(reinterpret_cast<const char*>(&count), sizeof count);
    file.write(head);
    writeRecords(file, mesh.triangles.size(), 50, progress, [&](RecordCursor& out, std::size_t f) {
        const auto corners = cornersOf(mesh, f);
        const base::Vec3f n = normalOf(corners);
        out.put(n.x).put(n.y).put(n.z);
        for (const base::Vec3d& corner : corners) {
            const base::Vec3f p = base::cast<float>(corner);
            out.put(p.x).put(p.y).put(p.z);
        }
        out.put(std::uint16_t(0));
    });
}

template <class T>
void appendVector(std::string& out, const char* key, const base::Vec3<T>& v) {
    out += key;
    for (std::size_t k = 0; k < 3; ++k) {
        out += ' ';
        appendNumber(out, v[k]);
    }
    out += '\n';
}

void writeText(SafeFile& file, const mesh::Mesh& mesh, const base::Vec3d& origin, const base::Progress& progress) {
    file.write("solid pointclay\n");
    writeRows(file, mesh.triangles.size(), progress, [&](std::string& out, std::size_t f) {
        const auto corners = cornersOf(mesh, f);
        appendVector(out, "facet normal", normalOf(corners));
        out += "outer loop\n";
        for (const base::Vec3d& corner : corners)
            appendVector(out, "vertex", corner + origin);
        out += "endloop\nendfacet\n";
    });
    file.write("endsolid pointclay\n");
}

} // namespace

void writeMeshStl(const path& target, const mesh::Mesh& mesh, const base::Vec3d& origin,
                  const base::Progress& progress) {
    SafeFile file(target);
    if (origin == base::Vec3d{})
        writeBinary(file, mesh, progress);
    else
        writeText(file, mesh, origin, progress);
    file.commit();
}

} // namespace io
