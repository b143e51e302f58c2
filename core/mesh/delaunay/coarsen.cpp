#include "core/mesh/delaunay/coarsen.h"

#include "core/mesh/check/shape.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

class Coarsening {
  public:
    Coarsening(SurfaceTriangulation& mesh, const SizeField& size, double distance, KeptClosed* closed)
        : m_mesh(mesh), m_size(size), m_distance(distance), m_closed(closed) {}

    bool shorten(std::uint32_t vertex);

  private:
    bool allowed(std::uint32_t vertex, std::uint32_t into);
    bool collapse(std::uint32_t vertex, std::uint32_t into);
    bool boundaryKeepsCourse(std::uint32_t vertex, std::uint32_t into);
    bool facesKeepFacing(std::uint32_t vertex, std::uint32_t into);

    SurfaceTriangulation& m_mesh;
    const SizeField& m_size;
    double m_distance;
    KeptClosed* m_closed;
    std::vector<std::uint32_t> m_ring, m_around;
};

/// Into the nearest neighbour that may take it.
bool Coarsening::shorten(std::uint32_t vertex) {
    m_mesh.neighbours(vertex, m_around);
    if (m_around.empty())
        return false;
    const Vec3d at = m_mesh.positions[vertex];
    const double size = m_size(at);
    std::vector<std::pair<double, std::uint32_t>> near;
    for (const std::uint32_t v : m_around)
        if (const double d = distance(at, m_mesh.positions[v]); d < size)
            near.emplace_back(d, v);
    std::sort(near.begin(), near.end());
    return std::any_of(near.begin(), near.end(),
                       [&](const auto& n) { return allowed(vertex, n.second) && collapse(vertex, n.second); });
}

bool Coarsening::collapse(std::uint32_t vertex, std::uint32_t into) {
    if (!m_closed)
        return m_mesh.collapse(vertex, into);
    m_mesh.oneRing(vertex, m_ring);
    if (!m_closed->mayCollapse(m_ring, vertex, into) || !m_mesh.collapse(vertex, into))
        return false;
    for (const std::uint32_t f : m_ring)
        m_closed->update(f);
    return true;
}

bool Coarsening::allowed(std::uint32_t vertex, std::uint32_t into) {
    return (!m_mesh.onBoundary(vertex) || boundaryKeepsCourse(vertex, into)) && facesKeepFacing(vertex, into);
}

bool Coarsening::boundaryKeepsCourse(std::uint32_t vertex, std::uint32_t into) {
    const auto [one, two] = m_mesh.boundarySides(vertex);
    const std::uint32_t before = m_mesh.otherEnd(one, vertex), after = m_mesh.otherEnd(two, vertex);
    if (before != into && after != into)
        return false;
    const Vec3d a = m_mesh.positions[before], ab = m_mesh.positions[after] - a, av = m_mesh.positions[vertex] - a;
    const double t = dot(av, ab) / lengthSq(ab);
    return t > 0 && t < 1 && length(av - ab * t) <= 0.5 * m_distance;
}

bool Coarsening::facesKeepFacing(std::uint32_t vertex, std::uint32_t into) {
    constexpr double facing = 0.9, turned = 0.5; // cosines
    constexpr double sharpest = 0.1;             // radians
    m_mesh.oneRing(vertex, m_ring);
    return std::all_of(m_ring.begin(), m_ring.end(), [&](std::uint32_t f) {
        Triangle t = m_mesh.corners(f);
        if (std::count(t.begin(), t.end(), into) > 0)
            return true;
        const auto sharpness = [&] {
            const auto [a, b, c] = m_mesh.cornersOf(t);
            return std::min(smallestAngle(a, b, c), sharpest);
        };
        const double angle = sharpness(), before = std::min(std::abs(m_mesh.facing(t)), facing);
        const Vec3d side = m_mesh.faceNormal(t);
        std::replace(t.begin(), t.end(), vertex, into);
        if (sharpness() < angle)
            return false;
        const bool sliver = angle < sharpest; // tells no direction
        return sliver || (std::abs(m_mesh.facing(t)) >= before && dot(side, m_mesh.faceNormal(t)) >= turned);
    });
}

/// Faces with two sides on the boundary that meet at a small angle.
void cutSharpCorners(SurfaceTriangulation& mesh) {
    const double sharp = 3.14159265358979323846 / 3;
    for (bool any = true; any;) {
        any = false;
        for (std::uint32_t f = 0; f < mesh.faceCount(); ++f)
            for (int k = 0; k < 3 && mesh.alive(f); ++k) {
                if (!mesh.onBoundary(Side{f, (k + 1) % 3}) || !mesh.onBoundary(Side{f, (k + 2) % 3}))
                    continue;
                const Triangle& t = mesh.corners(f);
                const Vec3d at = mesh.positions[t[std::size_t(k)]];
                const Vec3d u = base::normalized(mesh.positions[t[std::size_t((k + 1) % 3)]] - at),
                            v = base::normalized(mesh.positions[t[std::size_t((k + 2) % 3)]] - at);
                if (dot(u, v) > std::cos(sharp)) {
                    mesh.removeEar(f);
                    any = true;
                }
            }
    }
}

} // namespace

void coarsen(SurfaceTriangulation& mesh, const SizeField& size, double distance, const base::Progress& progress,
             KeptClosed* closed) {
    cutSharpCorners(mesh);
    Coarsening coarsening(mesh, size, distance, closed);
    constexpr int passes = 6;
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (int pass = 0; pass < passes; ++pass) {
        bool any = false;
        for (std::uint32_t v = 0; v < count; ++v) {
            if (v % 1024 == 0)
                progress.step((pass + double(v) / count) / passes, "Coarsening");
            any |= coarsening.shorten(v);
        }
        if (!any)
            break;
    }
}

} // namespace mesh
