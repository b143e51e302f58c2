#include "core/mesh/finish/untangle.h"

#include "core/mesh/check/self_intersections.h"
#include "core/mesh/finish/cuts_near.h"

namespace mesh {

std::size_t untangle(Mesh& mesh, const VertexPlaces& before, double cell, const base::Progress& progress) {
    constexpr int rounds = 16; // what goes back may now cut its neighbours
    std::size_t count = 0;
    auto cuts = selfIntersections(mesh, progress);
    for (int round = 0; round < rounds && !cuts.empty(); ++round) {
        progress.step(1, "untangling triangles");
        std::vector<std::uint32_t> around;
        for (const auto& [a, b] : cuts)
            for (const std::uint32_t t : {a, b})
                for (const std::uint32_t v : mesh.triangles[t]) {
                    if (mesh.positions[v] == before.positions[v])
                        continue;
                    mesh.positions[v] = before.positions[v];
                    mesh.normals[v] = before.normals[v];
                    around.push_back(v);
                }
        count += around.size();
        cuts = cutsNear(mesh, around, cell);
    }
    return count;
}

} // namespace mesh
