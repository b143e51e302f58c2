#include "core/mesh/delaunay/cut_guard.h"

#include "core/mesh/check/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mesh {

using base::Box3d, base::Vec3d;

/// Distant cubes may share one: then more is compared than need be.
static std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::uint64_t some = (1u << 21) - 1;
    return (std::uint64_t(x) & some) | (std::uint64_t(y) & some) << 21 | (std::uint64_t(z) & some) << 42;
}

CutGuard::CutGuard(const SurfaceTriangulation& mesh, double cell) : m_mesh(mesh), m_cell(cell) {
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
        update(f);
}

CutGuard::Cube CutGuard::cubeOf(const Vec3d& x) const {
    return {static_cast<std::int64_t>(std::floor(x.x / m_cell)), static_cast<std::int64_t>(std::floor(x.y / m_cell)),
            static_cast<std::int64_t>(std::floor(x.z / m_cell))};
}

Box3d CutGuard::boxOf(const Triangle& t) const {
    Box3d out;
    for (const Vec3d& corner : m_mesh.cornersOf(t))
        out.extend(corner);
    return out;
}

template <class Fn>
void CutGuard::forCubes(const Box3d& box, const Fn& fn) const {
    const Cube lo = cubeOf(box.lo), hi = cubeOf(box.hi);
    for (std::int64_t z = lo[2]; z <= hi[2]; ++z)
        for (std::int64_t y = lo[1]; y <= hi[1]; ++y)
            for (std::int64_t x = lo[0]; x <= hi[0]; ++x)
                fn(keyOf(x, y, z));
}

void CutGuard::update(std::uint32_t face) {
    if (m_boxes.size() < m_mesh.faceCount()) {
        m_boxes.resize(m_mesh.faceCount());
        m_seen.resize(m_mesh.faceCount());
    }
    leave(face);
    enter(face);
}

void CutGuard::leave(std::uint32_t face) {
    if (m_boxes[face].empty())
        return;
    forCubes(m_boxes[face], [&](std::uint64_t key) {
        const auto at = m_cubes.find(key);
        if (at == m_cubes.end())
            return;
        std::vector<std::uint32_t>& faces = at->second;
        if (const auto found = std::find(faces.begin(), faces.end(), face); found != faces.end()) {
            *found = faces.back();
            faces.pop_back();
        }
    });
    m_boxes[face] = {};
}

void CutGuard::enter(std::uint32_t face) {
    if (!m_mesh.alive(face))
        return;
    m_boxes[face] = boxOf(m_mesh.corners(face));
    forCubes(m_boxes[face], [&](std::uint64_t key) { m_cubes[key].push_back(face); });
}

bool CutGuard::cutsAny(const Triangle& t, std::span<const std::uint32_t> but) {
    const Box3d box = boxOf(t);
    ++m_question;
    bool out = false;
    forCubes(box, [&](std::uint64_t key) {
        const auto at = m_cubes.find(key);
        if (out || at == m_cubes.end())
            return;
        for (const std::uint32_t face : at->second) {
            if (std::exchange(m_seen[face], m_question) == m_question || !box.overlaps(m_boxes[face]) ||
                std::find(but.begin(), but.end(), face) != but.end())
                continue;
            const Triangle& other = m_mesh.corners(face);
            if (!isFlat(m_mesh.positions, other) && trianglesMeet(m_mesh.positions, t, other)) {
                out = true;
                return;
            }
        }
    });
    return out;
}

bool CutGuard::allows(std::span<const Triangle> made, std::span<const std::uint32_t> instead) {
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (isFlat(m_mesh.positions, made[i]))
            return false;
        for (std::size_t j = 0; j < i; ++j)
            if (trianglesMeet(m_mesh.positions, made[i], made[j]))
                return false;
    }
    return std::none_of(made.begin(), made.end(), [&](const Triangle& t) { return cutsAny(t, instead); });
}

} // namespace mesh
