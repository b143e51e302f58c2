#include "core/mesh/marching/hold_tolerance.h"

namespace mesh {

using base::Vec3d, base::Vec3f;

std::vector<std::uint8_t> farTriangles(const surface::Surface& surface, std::span<const Vec3d> centres,
                                       double tolerance) {
    std::vector<Vec3f> x;
    x.reserve(centres.size());
    for (const Vec3d& centre : centres)
        x.push_back(base::cast<float>(centre));
    std::vector<surface::Evaluationf> at(x.size());
    surface.evaluate(x, surface::Need::Gradient, at);
    std::vector<std::uint8_t> out(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3d gradient = base::cast<double>(at[i].gradient);
        const double value = double(at[i].value) + dot(gradient, centres[i] - base::cast<double>(x[i]));
        out[i] = !at[i].ok() || std::abs(value) > tolerance * length(gradient);
    }
    return out;
}

std::size_t holdTolerance(Mesh& mesh, const surface::Surface& surface, const VertexPlaces& before, double tolerance) {
    constexpr int rounds = 16; // what goes back pulls at its neighbours
    const auto centreOf = [&](std::uint32_t t) {
        const Triangle& corners = mesh.triangles[t];
        return (mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]]) / 3;
    };
    const auto movedOf = [&](std::uint32_t v) { return mesh.positions[v] != before.positions[v]; };
    std::vector<std::uint32_t> looked(mesh.triangles.size());
    for (std::uint32_t t = 0; t < looked.size(); ++t)
        looked[t] = t;
    std::size_t count = 0;
    for (int round = 0; round < rounds && !looked.empty(); ++round) {
        std::vector<Vec3d> centres;
        for (const std::uint32_t t : looked)
            centres.push_back(centreOf(t));
        const std::vector<std::uint8_t> far = farTriangles(surface, centres, tolerance);
        std::vector<std::uint8_t> back(mesh.positions.size());
        std::size_t some = 0;
        for (std::size_t i = 0; i < looked.size(); ++i)
            for (const std::uint32_t v : mesh.triangles[looked[i]])
                if (far[i] && movedOf(v) && !back[v])
                    back[v] = 1, ++some;
        if (some == 0)
            break;
        count += some;
        looked.clear();
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Triangle& corners = mesh.triangles[t];
            if (back[corners[0]] || back[corners[1]] || back[corners[2]])
                looked.push_back(t);
        }
        for (std::uint32_t v = 0; v < back.size(); ++v)
            if (back[v]) {
                mesh.positions[v] = before.positions[v];
                mesh.normals[v] = before.normals[v];
            }
    }
    return count;
}

} // namespace mesh
