#include "core/mesh/finish/untangle.h"

#include "core/mesh/check/self_intersections.h"
#include "core/mesh/finish/cuts_near.h"

#include <algorithm>

namespace mesh {

std::vector<std::pair<std::uint32_t, std::uint32_t>> untangle(Mesh& mesh, const VertexPlaces& before, double cell,
                                                              const base::Progress& progress) {
    constexpr int rounds = 16; // what goes back may now cut its neighbours
    std::vector<std::pair<std::uint32_t, std::uint32_t>> left;
    auto cuts = selfIntersections(mesh, progress);
    for (int round = 0; round < rounds && !cuts.empty(); ++round) {
        progress.step(1, "untangling triangles");
        std::vector<std::uint32_t> around;
        for (const auto& [a, b] : cuts) {
            const std::size_t moved = around.size();
            for (const std::uint32_t t : {a, b})
                for (const std::uint32_t v : mesh.triangles[t]) {
                    if (mesh.positions[v] == before.positions[v])
                        continue;
                    mesh.positions[v] = before.positions[v];
                    mesh.normals[v] = before.normals[v];
                    around.push_back(v);
                }
            if (around.size() == moved)
                left.emplace_back(a, b);
        }
        cuts = cutsNear(mesh, around, cell);
    }
    left.insert(left.end(), cuts.begin(), cuts.end());
    if (left.empty())
        return left;
    std::vector<std::uint32_t> among; // some were put right with their neighbours
    for (const auto& [a, b] : left)
        among.insert(among.end(), {a, b});
    std::sort(among.begin(), among.end());
    among.erase(std::unique(among.begin(), among.end()), among.end());
    return selfIntersections(mesh, among, progress);
}

} // namespace mesh
