// Meshes as text: Wavefront OBJ, with `vn` and colours of 0..1 behind the positions as most programs read them, and the
// Object File Format (Geomview) as OFF, NOFF, COFF or CNOFF.
#include "core/io/mesh_writers.h"
#include "core/io/number_text.h"
#include "core/io/text/text_output.h"

namespace io {

namespace {

template <class T>
void appendVector(std::string& out, const base::Vec3<T>& v) {
    for (std::size_t k = 0; k < 3; ++k) {
        out += ' ';
        appendNumber(out, v[k]);
    }
}

void appendCount(std::string& out, std::uint32_t value) {
    appendNumber(out, static_cast<std::int64_t>(value));
}

unsigned channel(surfel::Colour colour, unsigned k) {
    return colour >> (8 * k) & 0xff;
}

} // namespace

void writeMeshObj(const path& target, const mesh::Mesh& mesh, const base::Vec3d& origin,
                  const base::Progress& progress) {
    SafeFile file(target);
    file.write("# " + std::to_string(mesh.positions.size()) + " vertices, " + std::to_string(mesh.triangles.size()) +
               " triangles\n");
    writeRows(file, mesh.positions.size(), progress, [&](std::string& out, std::size_t i) {
        out += 'v';
        appendVector(out, mesh.positions[i] + origin);
        if (!mesh.colours.empty())
            appendVector(out, base::Vec3f{static_cast<float>(channel(mesh.colours[i], 0)) / 255,
                                          static_cast<float>(channel(mesh.colours[i], 1)) / 255,
                                          static_cast<float>(channel(mesh.colours[i], 2)) / 255});
        out += '\n';
        if (!mesh.normals.empty()) {
            out += "vn";
            appendVector(out, mesh.normals[i]);
            out += '\n';
        }
    });
    writeRows(file, mesh.triangles.size(), progress, [&](std::string& out, std::size_t f) {
        out += 'f';
        for (const std::uint32_t v : mesh.triangles[f]) {
            out += ' ';
            appendCount(out, v + 1);
            if (!mesh.normals.empty()) {
                out += "//";
                appendCount(out, v + 1);
            }
        }
        out += '\n';
    });
    file.commit();
}

void writeMeshOff(const path& target, const mesh::Mesh& mesh, const base::Vec3d& origin,
                  const base::Progress& progress) {
    SafeFile file(target);
    file.write(std::string(mesh.colours.empty() ? "" : "C") + (mesh.normals.empty() ? "" : "N") + "OFF\n" +
               std::to_string(mesh.positions.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n");
    writeRows(file, mesh.positions.size(), progress, [&](std::string& out, std::size_t i) {
        const base::Vec3d p = mesh.positions[i] + origin;
        appendNumber(out, p.x);
        out += ' ';
        appendNumber(out, p.y);
        out += ' ';
        appendNumber(out, p.z);
        if (!mesh.normals.empty())
            appendVector(out, mesh.normals[i]);
        for (unsigned k = 0; !mesh.colours.empty() && k < 4; ++k) {
            out += ' ';
            appendCount(out, channel(mesh.colours[i], k));
        }
        out += '\n';
    });
    writeRows(file, mesh.triangles.size(), progress, [&](std::string& out, std::size_t f) {
        out += '3';
        for (const std::uint32_t v : mesh.triangles[f]) {
            out += ' ';
            appendCount(out, v);
        }
        out += '\n';
    });
    file.commit();
}

} // namespace io
