#include "core/mesh/check/deviation.h"

#include "core/base/parallel.h"
#include "core/cells/cell_projection.h"
#include "core/complexes/complex_projection.h"
#include "core/surface/curves/boundary.h"
#include "core/surface/projection/project.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;
using surface::Status;

namespace {

constexpr double none = std::numeric_limits<double>::infinity();

/// f over its slope, where that tells the distance: so close to the surface that its bending does not count.
double byOneEvaluation(const surface::Surface& surface, const Vec3d& x, const surface::OrientationHint& hint) {
    constexpr double close = 1e-3, rounding = 1e-5; // of h
    const surface::Evaluationd e = surface.evaluateReference(x, surface::Need::Gradient, hint);
    if (!e.ok() && e.status != Status::BeyondBoundary)
        return none;
    const double limit = double(surface.definition().boundaryLimit);
    const double slope = length(e.gradient);
    if (!(std::abs(e.value) <= close * e.unit * slope) || !(e.offCentre <= (limit + rounding) * e.unit))
        return none;
    return std::abs(e.value) / slope;
}

/// Of models with cells: to the local Boolean, where several of them are near; of complexes to the nearest cell.
class DistanceTo {
  public:
    explicit DistanceTo(const surface::Surface& surface)
        : m_surface(surface), m_cells(cells::CellSurface::of(surface)), m_complex(complexes::Complex::of(surface)) {}

    double operator()(const Vec3d& x, const surface::OrientationHint& hint) const {
        if (m_complex) {
            const complexes::CellFoot foot = project(*m_complex, x, surface::Projector::Almost);
            return foot.ok() ? distance(x, foot.position) : none;
        }
        if (m_cells) {
            cells::CellSource source(*m_cells);
            source.moveTo(x);
            if (source.count() > 1) {
                const cells::CellFoot found = cells::project(*m_cells, x);
                return found.projection.ok() ? distance(x, found.projection.foot) : none;
            }
        }
        return distanceTo(m_surface, x, hint);
    }

  private:
    const surface::Surface& m_surface;
    std::optional<cells::CellSurface> m_cells;
    std::optional<complexes::Complex> m_complex;
};

/// `each(i)` tells the distance of the i-th place.
template <class Each>
Deviation collect(std::size_t n, const base::Progress& progress, const char* what, const Each& each) {
    constexpr std::size_t slab = 1 << 14;
    std::vector<double> all(n);
    for (std::size_t first = 0; first < n; first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), what);
        base::parallelFor(std::min(slab, n - first), 64, [&](std::size_t i) { all[first + i] = each(first + i); });
    }
    Deviation out;
    out.count = n;
    std::sort(all.begin(), all.end());
    while (!all.empty() && !std::isfinite(all.back()))
        all.pop_back();
    out.lost = n - all.size();
    if (!all.empty()) {
        out.max = all.back();
        out.hundredth = all[all.size() - 1 - all.size() / 100];
        out.median = all[all.size() / 2];
    }
    return out;
}

} // namespace

double distanceTo(const surface::Surface& surface, const Vec3d& x, const surface::OrientationHint& hint) {
    // what the surface answers unasked is what rays and cubes meet; the hint tells sheets apart further away
    for (const surface::OrientationHint& asked : {surface::OrientationHint{}, hint})
        if (const double near = byOneEvaluation(surface, x, asked); near < none)
            return near;
    const auto found = projectReference(surface, x, {}, hint);
    if (found.ok())
        return distance(x, found.foot);
    if (found.status != Status::BeyondBoundary)
        return none;
    const surface::BoundarySearch boundary = findBoundaryPoint(surface, found.foot, hint);
    return boundary.ok() ? distance(x, boundary.point.position) : none;
}

Deviation vertexDeviation(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            used[v] = true;
    std::vector<std::uint32_t> which;
    for (std::uint32_t v = 0; v < used.size(); ++v)
        if (used[v])
            which.push_back(v);
    const DistanceTo far(surface);
    return collect(which.size(), progress, "Measuring vertices", [&](std::size_t i) {
        const std::uint32_t v = which[i];
        return far(mesh.positions[v], {mesh.normals.empty() ? base::Vec3f{} : mesh.normals[v]});
    });
}

Deviation faceDeviation(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    const DistanceTo far(surface);
    return collect(mesh.triangles.size(), progress, "Measuring faces", [&](std::size_t f) {
        const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[f][k]]; };
        const Vec3d centre = (at(0) + at(1) + at(2)) / 3;
        const Vec3d across = base::normalized(cross(at(1) - at(0), at(2) - at(0)));
        return far(centre, {base::cast<float>(across)});
    });
}

} // namespace mesh
