#include "core/mesh/delaunay/held_faces.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

bool offSurface(SurfaceTriangulation& mesh, std::uint32_t face) {
    constexpr double tall = 0.5; // of the longest side
    const Triangle& t = mesh.corners(face);
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return mesh.kinds[v] == VertexKind::Bridge; }))
        return true;
    const auto [a, b, c] = mesh.cornersOf(t);
    const double reach = tall * std::max({distance(a, b), distance(b, c), distance(c, a)});
    return !(mesh.facing(t) > 0) || !mesh.root((a + b + c) / 3, mesh.faceNormal(t), reach, mesh.surfaceNormal(t));
}

/// Faces with two and more neighbours that are held, again and again: what is left has no corners that are too sharp.
void enclose(const SurfaceTriangulation& mesh, std::vector<bool>& held) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t f = 0; f < held.size(); ++f)
        if (held[f])
            open.push_back(f);
    const auto neighboursHeld = [&](std::uint32_t f) {
        int out = 0;
        for (int k = 0; k < 3; ++k)
            if (const Side other = mesh.across({f, k}); other.exists() && held[other.face])
                ++out;
        return out;
    };
    while (!open.empty()) {
        const std::uint32_t f = open.back();
        open.pop_back();
        for (int k = 0; k < 3; ++k) {
            const Side other = mesh.across({f, k});
            if (!other.exists() || held[other.face] || neighboursHeld(other.face) < 2)
                continue;
            held[other.face] = true;
            open.push_back(other.face);
        }
    }
}

} // namespace

std::vector<bool> heldFaces(SurfaceTriangulation& mesh, const base::Progress& progress) {
    std::vector<bool> out(mesh.faceCount());
    for (std::uint32_t f = 0; f < out.size(); ++f) {
        if (f % 4096 == 0)
            progress.step(double(f) / double(out.size()), "Looking for gaps");
        out[f] = mesh.alive(f) && offSurface(mesh, f);
    }
    enclose(mesh, out);
    return out;
}

} // namespace mesh
