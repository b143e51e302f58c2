#include "core/mesh/delaunay/delaunay_finish.h"

#include "core/base/parallel.h"
#include "core/mesh/check/deviation.h"
#include "core/mesh/check/shape.h"
#include "core/mesh/connectivity/boundary_loops.h"
#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/finish/own_sheet.h"
#include "core/surface/projection/project.h"
#include "core/surface/rims.h"

#include <utility>

namespace mesh {

using base::Vec3d;

namespace {

/// h there; 0 where the surface has no value.
double unitAt(const surface::Surface& surface, const Vec3d& x, const base::Vec3f& normal) {
    const surface::Evaluationf at = surface.evaluate(base::cast<float>(x), surface::Need::Value, {normal});
    return at.ok() || at.status == surface::Status::BeyondBoundary ? double(at.unit) : 0;
}

/// On a vertex' own sheet; of a closed surface without steps on what is there.
std::optional<Vec3d> footOf(const surface::Surface& surface, const SurfaceTraits& traits, const Vec3d& x,
                            const base::Vec3f& normal, double farthest) {
    if (traits.closed && traits.continuous) {
        const auto found = surface::projectReference(surface, x);
        return found.ok() && distance(found.foot, x) <= farthest ? std::optional(found.foot) : std::nullopt;
    }
    const auto found = ontoOwnSheet(surface, traits, x, normal, farthest);
    return found ? std::optional(found->position) : std::nullopt;
}

/// Where vertices lie on their own sheets; those on the boundary curve and on bridges stay, and those without a foot
/// near.
std::vector<Vec3d> feetOf(const surface::Surface& surface, const Mesh& mesh) {
    constexpr double most = 0.05; // of h there: further is another part of the surface
    const SurfaceTraits traits(surface);
    std::vector<Vec3d> out = mesh.positions;
    base::parallelFor(out.size(), 64, [&](std::size_t v) {
        if (mesh.kinds[v] == VertexKind::Limit || mesh.kinds[v] == VertexKind::Bridge)
            return;
        const double unit = unitAt(surface, out[v], mesh.normals[v]);
        if (const auto foot = footOf(surface, traits, out[v], mesh.normals[v], most * unit))
            out[v] = *foot;
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
    const SurfaceTraits traits(surface);
    const bool plain = traits.closed && traits.continuous;
    base::parallelFor(mesh.positions.size(), 64, [&](std::size_t v) {
        if (mesh.kinds[v] == VertexKind::Bridge)
            return;
        const surface::OrientationHint sheet{plain ? base::Vec3f{} : mesh.normals[v]};
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

void tellBoundaryKinds(const surface::Surface& surface, Mesh& mesh) {
    constexpr double nearLimit = 0.5;
    const double limit = double(surface.definition().boundaryLimit);
    const std::vector<bool> boundary = boundaryVertices(Triangulation(mesh));
    base::parallelFor(mesh.positions.size(), 64, [&](std::size_t v) {
        if (!boundary[v] || mesh.kinds[v] == VertexKind::Limit) {
            mesh.kinds[v] = boundary[v] ? VertexKind::Limit : VertexKind::Inner;
            return;
        }
        const surface::Evaluationd e =
            surface.evaluateReference(mesh.positions[v], surface::Need::Value, {mesh.normals[v]});
        const bool usable = e.ok() || e.status == surface::Status::BeyondBoundary;
        const bool atLimit = usable && e.offCentre > nearLimit * limit * e.unit;
        mesh.kinds[v] = atLimit && surface::mayEnd(surface, mesh.positions[v]) ? VertexKind::Limit : VertexKind::Fold;
    });
}

} // namespace mesh
