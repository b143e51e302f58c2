#include "core/mesh/connectivity/umbrellas.h"

namespace mesh {

std::vector<std::uint32_t> umbrellasOf(const Triangulation& triangulation) {
    std::vector<std::uint32_t> out(3 * std::size_t(triangulation.faceCount()), Triangulation::none);
    for (std::uint32_t corner = 0; corner < out.size(); ++corner) {
        const std::uint32_t f = corner / 3;
        const int i = static_cast<int>(corner % 3);
        if (out[corner] != Triangulation::none || !triangulation.alive(f))
            continue;
        const std::uint32_t vertex = triangulation.corners(f)[corner % 3];
        const auto mark = [&](std::uint32_t face) {
            out[3 * std::size_t(face) + std::size_t(triangulation.cornerOf(face, vertex))] = corner;
        };
        mark(f);
        if (triangulation.turn(vertex, {f, (i + 1) % 3}, mark).exists())
            triangulation.turn(vertex, {f, (i + 2) % 3}, mark);
    }
    return out;
}

} // namespace mesh
