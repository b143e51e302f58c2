#include "core/mesh/delaunay/delaunay_finish.h"

#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/mesh/check/deviation.h"
#include "core/mesh/check/shape.h"
#include "core/mesh/edges.h"
#include "core/mesh/marching/own_sheet.h"
#include "core/mesh/mesh_repair.h"

#include <map>
#include <utility>

namespace mesh {

using base::Vec3d;

namespace {

constexpr std::uint32_t none = ~0u;

double areaOf(const Mesh& mesh, const Triangle& t) {
    const Vec3d& a = mesh.positions[t[0]];
    return 0.5 * length(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
}

/// Marks what is too much at edges of three triangles and more; returns how many.
std::size_t markExcess(const Mesh& mesh, std::vector<bool>& excess) {
    std::size_t out = 0;
    forEdges(edgeUses(mesh.triangles), [&](std::span<const EdgeUse> uses) {
        std::vector<std::pair<double, std::uint32_t>> left;
        for (const EdgeUse& use : uses)
            if (!excess[use.face()])
                left.emplace_back(areaOf(mesh, mesh.triangles[use.face()]), use.face());
        std::sort(left.begin(), left.end());
        for (std::size_t i = 0; i + 2 < left.size(); ++i, ++out)
            excess[left[i].second] = true;
    });
    return out;
}

void splitFans(Mesh& mesh) {
    base::DisjointSets fans(3 * mesh.triangles.size());
    forEdges(edgeUses(mesh.triangles), [&](std::span<const EdgeUse> edge) {
        if (edge.size() != 2)
            return;
        const bool opposed = edge[0].forward == edge[1].forward;
        fans.join(edge[0].corner, opposed ? edge[1].corner : edge[1].next());
        fans.join(edge[0].next(), opposed ? edge[1].next() : edge[1].corner);
    });
    std::vector<std::uint32_t> fanOf(mesh.positions.size(), none);
    std::map<std::uint32_t, std::uint32_t> fresh; // vertex of a further fan
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        std::uint32_t& v = mesh.triangles[corner / 3][corner % 3];
        const std::uint32_t fan = fans.find(corner);
        if (fanOf[v] == none)
            fanOf[v] = fan;
        if (fanOf[v] == fan)
            continue;
        const auto [at, isNew] = fresh.try_emplace(fan, static_cast<std::uint32_t>(mesh.positions.size()));
        if (isNew) {
            mesh.positions.push_back(mesh.positions[v]);
            mesh.kinds.push_back(mesh.kinds[v]);
            if (!mesh.normals.empty())
                mesh.normals.push_back(mesh.normals[v]);
            fanOf.push_back(fan);
        }
        v = at->second;
    }
}

std::vector<bool> boundaryVertices(const Mesh& mesh) {
    std::vector<bool> out(mesh.positions.size(), false);
    forEdges(edgeUses(mesh.triangles), [&](std::span<const EdgeUse> edge) {
        if (edge.size() == 1)
            out[edge[0].low] = out[edge[0].high] = true;
    });
    return out;
}

} // namespace

std::size_t makeManifold(Mesh& mesh) {
    std::vector<bool> excess(mesh.triangles.size(), false);
    const std::size_t out = markExcess(mesh, excess);
    keepTriangles(mesh, [&](std::size_t f) { return !excess[f]; });
    splitFans(mesh);
    return out;
}

namespace {

/// Where vertices lie on their own sheets; those of rims stay, and those without a place near.
std::vector<Vec3d> feetOf(const surface::Surface& surface, const Mesh& mesh) {
    constexpr double most = 0.05; // of the largest support: further is another place
    const double farthest = most * double(surface.tree().maxSupport());
    const WalkSetting setting(surface);
    std::vector<Vec3d> out = mesh.positions;
    base::parallelFor(out.size(), 64, [&](std::size_t v) {
        if (mesh.kinds[v] != VertexKind::Limit)
            if (const auto foot = ontoOwnSheet(surface, setting, out[v], mesh.normals[v], farthest))
                out[v] = foot->position;
    });
    return out;
}

/// Takes back moves that spoil a triangle: steps of f, where near sheets meet, lie between a root and its foot.
void takeBackSpoiling(const std::vector<Vec3d>& before, double leastAngle, Mesh& mesh) {
    const auto across = [](const std::vector<Vec3d>& at, const Triangle& t) {
        return base::normalized(cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]));
    };
    const auto spoiled = [&](const Triangle& t) {
        constexpr double turned = 0.9; // cosine
        const std::vector<Vec3d>& at = mesh.positions;
        const double least = std::min(leastAngle, smallestAngle(before[t[0]], before[t[1]], before[t[2]]));
        return smallestAngle(at[t[0]], at[t[1]], at[t[2]]) < least || dot(across(at, t), across(before, t)) < turned;
    };
    for (bool any = true; any;) {
        any = false;
        std::vector<std::uint32_t> back;
        for (const Triangle& t : mesh.triangles)
            if (mesh.positions[t[0]] != before[t[0]] || mesh.positions[t[1]] != before[t[1]] ||
                mesh.positions[t[2]] != before[t[2]])
                if (spoiled(t))
                    back.insert(back.end(), t.begin(), t.end());
        for (const std::uint32_t v : back) {
            any = true;
            mesh.positions[v] = before[v];
        }
    }
}

} // namespace

void settleVertices(const surface::Surface& surface, double leastAngle, Mesh& mesh) {
    const std::vector<Vec3d> before = std::exchange(mesh.positions, feetOf(surface, mesh));
    takeBackSpoiling(before, leastAngle, mesh);
    base::parallelFor(mesh.positions.size(), 64, [&](std::size_t v) {
        const surface::OrientationHint sheet{mesh.normals[v]};
        const surface::Evaluationd e = surface.evaluateReference(mesh.positions[v], surface::Need::Gradient, sheet);
        if (e.ok() || e.status == surface::Status::BeyondBoundary)
            mesh.normals[v] = base::cast<float>(base::normalized(e.gradient));
    });
}

std::size_t leaveOutFar(const surface::Surface& surface, double farthest, Mesh& mesh) {
    const auto nearEnough = [&](const Vec3d& x, const base::Vec3f& normal, double most) {
        constexpr float sure = 0.7f;
        const surface::Evaluationf e = surface.evaluate(base::cast<float>(x), surface::Need::Gradient, {normal});
        if (e.ok() && std::abs(e.value) <= sure * static_cast<float>(most) * length(e.gradient))
            return true;
        return distanceTo(surface, x, {normal}) <= most;
    };
    std::vector<char> good(mesh.positions.size()), keep(mesh.triangles.size());
    base::parallelFor(good.size(), 64,
                      [&](std::size_t v) { good[v] = nearEnough(mesh.positions[v], mesh.normals[v], 0.1 * farthest); });
    base::parallelFor(keep.size(), 64, [&](std::size_t f) {
        const Triangle& t = mesh.triangles[f];
        const Vec3d a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        const Vec3d across = base::normalized(cross(b - a, c - a));
        keep[f] =
            good[t[0]] && good[t[1]] && good[t[2]] && nearEnough((a + b + c) / 3, base::cast<float>(across), farthest);
    });
    return keepTriangles(mesh, [&](std::size_t f) { return keep[f] != 0; });
}

void tellRims(const surface::Surface& surface, Mesh& mesh) {
    constexpr double nearLimit = 0.5;
    const double limit = double(surface.definition().boundaryLimit);
    const std::vector<bool> boundary = boundaryVertices(mesh);
    base::parallelFor(mesh.positions.size(), 64, [&](std::size_t v) {
        if (!boundary[v] || mesh.kinds[v] == VertexKind::Limit) {
            mesh.kinds[v] = boundary[v] ? VertexKind::Limit : VertexKind::Inner;
            return;
        }
        const surface::Evaluationd e =
            surface.evaluateReference(mesh.positions[v], surface::Need::Value, {mesh.normals[v]});
        const bool usable = e.ok() || e.status == surface::Status::BeyondBoundary;
        mesh.kinds[v] = usable && e.offCentre > nearLimit * limit * e.unit ? VertexKind::Limit : VertexKind::Fold;
    });
}

std::size_t dropCrumbs(Mesh& mesh, const Orientation& pieces) {
    constexpr std::uint32_t crumb = 12;
    std::vector<bool> atFold(pieces.pieceSizes.size(), false);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (const std::uint32_t v : mesh.triangles[f])
            if (mesh.kinds[v] == VertexKind::Fold)
                atFold[pieces.pieceOf[f]] = true;
    return keepTriangles(mesh, [&](std::size_t f) {
        const std::uint32_t piece = pieces.pieceOf[f];
        return !atFold[piece] || pieces.pieceSizes[piece] >= crumb;
    });
}

} // namespace mesh
