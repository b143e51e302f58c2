#include "core/mesh/delaunay/held_faces.h"

#include "core/mesh/check/shape.h"

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
    return !(mesh.facing(t) > 0) || !mesh.root((a + b + c) / 3, mesh.faceNormal(t), reach, mesh.facingOf(t));
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

/// Returns whether the side was flipped.
bool shapeSide(SurfaceTriangulation& mesh, KeptClosed& closed, const Side& s) {
    constexpr double flat = 0.9, better = 1e-9; // cosine; radians
    const Side other = mesh.across(s);
    if (!other.exists() || !closed.held(other.face))
        return false;
    mesh.align(s);
    const std::uint32_t p = mesh.apex(s), q = mesh.apex(mesh.across(s)), a = mesh.from(s), b = mesh.to(s);
    const Triangle was{p, a, b}, beside{q, b, a}, first{p, a, q}, second{q, b, p};
    const auto least = [&](const Triangle& t) {
        const auto [u, v, w] = mesh.cornersOf(t);
        return smallestAngle(u, v, w);
    };
    const Vec3d normal = mesh.faceNormal(was);
    const std::array others{beside, first, second};
    const std::array pair{s.face, other.face};
    if (std::min(least(first), least(second)) <= std::min(least(was), least(beside)) + better ||
        !std::all_of(others.begin(), others.end(),
                     [&](const Triangle& t) { return dot(mesh.faceNormal(t), normal) > flat; }) ||
        !closed.allows(std::array{first, second}, pair) || !mesh.flip(s))
        return false;
    for (const std::uint32_t f : pair)
        closed.update(f);
    return true;
}

} // namespace

std::vector<bool> bubbles(const SurfaceTriangulation& mesh, const KeptClosed& closed) {
    std::vector<bool> out(mesh.faceCount(), true);
    std::vector<std::uint32_t> open;
    const auto reach = [&](std::uint32_t f) {
        if (out[f])
            open.push_back(f);
        out[f] = false;
    };
    for (std::uint32_t f = 0; f < out.size(); ++f)
        if (mesh.alive(f) && !closed.held(f))
            reach(f);
    if (open.empty())
        out.assign(out.size(), false);
    while (!open.empty()) {
        const std::uint32_t f = open.back();
        open.pop_back();
        for (int k = 0; k < 3; ++k)
            if (const Side other = mesh.across({f, k}); other.exists())
                reach(other.face);
    }
    return out;
}

void shapeHeld(SurfaceTriangulation& mesh, KeptClosed& closed, const base::Progress& progress) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
        if (mesh.alive(f) && closed.held(f))
            open.push_back(f);
    for (std::size_t i = 0, most = 100 * open.size(); !open.empty() && i < most; ++i) {
        if (i % 4096 == 0)
            progress.step(0, "Flipping");
        const std::uint32_t f = open.back();
        open.pop_back();
        for (int k = 0; k < 3; ++k) {
            const Side s{f, k}, other = mesh.across(s);
            if (!shapeSide(mesh, closed, s))
                continue;
            open.insert(open.end(), {f, other.face});
            break;
        }
    }
}

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
