#include "core/mesh/finish/untangle.h"

#include "core/mesh/check/self_intersections.h"
#include "core/mesh/finish/cuts_near.h"

#include <algorithm>

namespace mesh {

/// Where few have moved, as at creases, only what is near them can cut anything that did not before.
static std::vector<std::pair<std::uint32_t, std::uint32_t>> cutsOfMoved(const Mesh& mesh, const VertexPlaces& before,
                                                                        double cell, const base::Progress& progress) {
    constexpr std::size_t few = 4; // of so many vertices one
    std::vector<std::uint32_t> moved;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        if (mesh.positions[v] != before.positions[v])
            moved.push_back(v);
    return few * moved.size() < mesh.positions.size() ? cutsNear(mesh, moved, cell) : selfIntersections(mesh, progress);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> untangle(Mesh& mesh, const VertexPlaces& before, double cell,
                                                              const base::Progress& progress) {
    constexpr int rounds = 16; // what goes back may now cut its neighbours
    std::vector<std::pair<std::uint32_t, std::uint32_t>> left;
    auto cuts = cutsOfMoved(mesh, before, cell, progress);
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
