#include "core/mesh/finish/orient_mesh.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/mesh/connectivity/triangulation.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

constexpr std::size_t grain = 16384;
constexpr std::uint32_t none = Triangulation::none;

struct SharedEdge {
    std::uint32_t a = 0, b = 0; ///< triangles, a < b
    bool agrees = false;        ///< do they run opposite ways along it, as neighbours should?
    float flatness = 0;
};

Vec3d areaNormal(const Mesh& mesh, const Triangle& t) {
    const Vec3d& a = mesh.positions[t[0]];
    return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

std::vector<SharedEdge> sharedEdges(const Mesh& mesh) {
    const Triangulation triangulation(mesh);
    std::vector<std::vector<SharedEdge>> parts(base::chunkCount(mesh.triangles.size(), grain));
    base::parallelChunks(mesh.triangles.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        parts[chunk].reserve(3 * (end - begin) / 2);
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
            for (const int k : Triangulation::sides) {
                const Side side{t, k}, other = triangulation.across(side);
                if (!other.exists() || other.face < t)
                    continue;
                const Vec3d a = normalized(areaNormal(mesh, mesh.triangles[t]));
                const Vec3d b = normalized(areaNormal(mesh, mesh.triangles[other.face]));
                parts[chunk].push_back(
                    {t, other.face, triangulation.agrees(side), static_cast<float>(std::abs(dot(a, b)))});
            }
    });
    std::vector<SharedEdge> out;
    for (const auto& part : parts)
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

/// By steps of flatness, within a step as they come.
std::vector<SharedEdge> flattestFirst(const std::vector<SharedEdge>& edges) {
    constexpr std::size_t steps = 1024;
    const auto stepOf = [](const SharedEdge& e) {
        return static_cast<std::size_t>((1 - std::clamp(e.flatness, 0.0f, 1.0f)) * float(steps - 1));
    };
    std::vector<std::size_t> first(steps + 1);
    for (const SharedEdge& e : edges)
        ++first[stepOf(e) + 1];
    for (std::size_t step = 0; step < steps; ++step)
        first[step + 1] += first[step];
    std::vector<SharedEdge> out(edges.size());
    for (const SharedEdge& e : edges)
        out[first[stepOf(e)]++] = e;
    return out;
}

void turn(Triangle& t) {
    std::swap(t[1], t[2]);
}

/// Numbers the sets by their first triangles.
void number(base::ParitySets& sets, Orientation& out) {
    std::vector<std::uint32_t> numberOf(out.pieceOf.size(), none);
    for (std::size_t t = 0; t < out.pieceOf.size(); ++t) {
        std::uint32_t& piece = numberOf[sets.find(static_cast<std::uint32_t>(t)).root];
        if (piece == none) {
            piece = static_cast<std::uint32_t>(out.pieceSizes.size());
            out.pieceSizes.push_back(0);
        }
        out.pieceOf[t] = piece;
        ++out.pieceSizes[piece];
    }
}

/// For each piece, how much speaks for its triangles as they run.
std::vector<double> votes(const Mesh& mesh, const Orientation& pieces, bool byNormals) {
    std::vector<double> out(pieces.pieceSizes.size());
    std::vector<Vec3d> middle(out.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        middle[pieces.pieceOf[t]] +=
            mesh.positions[mesh.triangles[t][0]] / double(pieces.pieceSizes[pieces.pieceOf[t]]);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const std::uint32_t piece = pieces.pieceOf[i];
        const Vec3d area = areaNormal(mesh, t);
        const Vec3d towards = byNormals
                                  ? base::cast<double>(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]])
                                  : mesh.positions[t[0]] - middle[piece];
        out[piece] += dot(area, towards);
    }
    return out;
}

/// Vertex normals of either sign take the side of their triangles.
void turnNormals(Mesh& mesh) {
    std::vector<Vec3d> sums(mesh.positions.size());
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            sums[v] += areaNormal(mesh, t);
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (dot(sums[v], base::cast<double>(mesh.normals[v])) < 0)
            mesh.normals[v] = -mesh.normals[v];
}

} // namespace

Orientation orient(Mesh& mesh, bool byNormals) {
    Orientation out;
    out.pieceOf.resize(mesh.triangles.size());
    std::vector<SharedEdge> edges = sharedEdges(mesh);
    const bool agreed = std::all_of(edges.begin(), edges.end(), [](const SharedEdge& e) { return e.agrees; });
    if (!agreed)
        edges = flattestFirst(edges);
    base::ParitySets sets(mesh.triangles.size());
    for (const SharedEdge& edge : edges)
        sets.relate(edge.a, edge.b, !edge.agrees);
    if (!agreed) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            if (sets.find(static_cast<std::uint32_t>(t)).opposite)
                turn(mesh.triangles[t]);
        for (const SharedEdge& edge : edges) {
            const bool turned = sets.find(edge.a).opposite != sets.find(edge.b).opposite;
            out.conflicts += edge.agrees == turned ? 1 : 0;
        }
    }
    number(sets, out);
    const std::vector<double> sides = votes(mesh, out, byNormals);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (sides[out.pieceOf[t]] < 0)
            turn(mesh.triangles[t]);
    if (!byNormals)
        turnNormals(mesh);
    return out;
}

} // namespace mesh
