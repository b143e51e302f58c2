#include "core/mesh/finish/make_manifold.h"

#include "core/mesh/connectivity/umbrellas.h"
#include "core/mesh/finish/drop_triangles.h"

#include <algorithm>
#include <map>

namespace mesh {

using base::Vec3d;

namespace {

double areaOf(const Mesh& mesh, const Triangle& t) {
    const Vec3d& a = mesh.positions[t[0]];
    return 0.5 * length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
}

/// Marks what is too much at edges of three triangles and more; returns how many.
std::size_t markExcess(const Mesh& mesh, std::vector<bool>& excess) {
    std::size_t out = 0;
    const Triangulation triangulation(mesh);
    triangulation.forEdges([&](const Side& first) {
        if (triangulation.facesAtEdge(first) < 3)
            return;
        std::vector<std::pair<double, std::uint32_t>> left;
        Side at = first;
        do {
            if (!excess[at.face])
                left.emplace_back(areaOf(mesh, mesh.triangles[at.face]), at.face);
            at = triangulation.next(at);
        } while (at != first);
        std::sort(left.begin(), left.end());
        for (std::size_t i = 0; i + 2 < left.size(); ++i, ++out)
            excess[left[i].second] = true;
    });
    return out;
}

void splitUmbrellas(Mesh& mesh) {
    const std::vector<std::uint32_t> umbrellas = umbrellasOf(Triangulation(mesh));
    std::vector<std::uint32_t> umbrellaOf(mesh.positions.size(), Triangulation::none);
    std::map<std::uint32_t, std::uint32_t> fresh; // vertex of a further umbrella
    for (std::size_t corner = 0; corner < umbrellas.size(); ++corner) {
        std::uint32_t& v = mesh.triangles[corner / 3][corner % 3];
        const std::uint32_t umbrella = umbrellas[corner];
        if (umbrellaOf[v] == Triangulation::none)
            umbrellaOf[v] = umbrella;
        if (umbrellaOf[v] == umbrella)
            continue;
        const auto [at, isNew] = fresh.try_emplace(umbrella, static_cast<std::uint32_t>(mesh.positions.size()));
        if (isNew) {
            mesh.positions.push_back(mesh.positions[v]);
            mesh.kinds.push_back(mesh.kinds[v]);
            if (!mesh.normals.empty())
                mesh.normals.push_back(mesh.normals[v]);
            umbrellaOf.push_back(umbrella);
        }
        v = at->second;
    }
}

} // namespace

std::size_t makeManifold(Mesh& mesh) {
    std::vector<bool> excess(mesh.triangles.size(), false);
    const std::size_t out = markExcess(mesh, excess);
    keepTriangles(mesh, [&](std::size_t f) { return !excess[f]; });
    splitUmbrellas(mesh);
    return out;
}

} // namespace mesh
