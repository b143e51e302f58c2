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
    const auto centresOf = [&](std::span<const std::uint32_t> some, std::span<const Vec3d> positions) {
        std::vector<Vec3d> out;
        for (const std::uint32_t t : some) {
            const Triangle& corners = mesh.triangles[t];
            out.push_back((positions[corners[0]] + positions[corners[1]] + positions[corners[2]]) / 3);
        }
        return out;
    };
    // those of some that are too far away, or that are not, with vertices there
    const auto farOf = [&](std::span<const std::uint32_t> some, std::span<const Vec3d> positions, bool yes) {
        const std::vector<std::uint8_t> far = farTriangles(surface, centresOf(some, positions), tolerance);
        std::vector<std::uint32_t> out;
        for (std::size_t i = 0; i < some.size(); ++i)
            if ((far[i] != 0) == yes)
                out.push_back(some[i]);
        return out;
    };
    const auto movedOf = [&](std::uint32_t v) { return mesh.positions[v] != before.positions[v]; };
    std::vector<std::uint32_t> looked(mesh.triangles.size());
    for (std::uint32_t t = 0; t < looked.size(); ++t)
        looked[t] = t;
    std::size_t count = 0;
    for (int round = 0; round < rounds && !looked.empty(); ++round) {
        const std::vector<std::uint32_t> spoiled = farOf(farOf(looked, mesh.positions, true), before.positions, false);
        std::vector<std::uint8_t> back(mesh.positions.size());
        std::size_t some = 0;
        for (const std::uint32_t t : spoiled)
            for (const std::uint32_t v : mesh.triangles[t])
                if (movedOf(v) && !back[v])
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
