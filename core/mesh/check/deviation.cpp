#include "core/mesh/check/deviation.h"

#include "core/base/parallel.h"
#include "core/cells/cell_projection.h"
#include "core/cells/local_boolean.h"
#include "core/complexes/complex_projection.h"
#include "core/surface/curves/boundary.h"
#include "core/surface/projection/project.h"
#include "core/surface/rims.h"

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
    const double slope = length(e.gradient);
    if (!(std::abs(e.value) <= close * e.unit * slope) ||
        surface::isPastEnd(surface, x, e.offCentre - rounding * e.unit, e.unit))
        return none;
    return std::abs(e.value) / slope;
}

/// The same by cells: the nearest foot of those that nothing cuts off where they are, and that far in.
double byOneEvaluation(cells::CellSource& source, const Vec3d& x) {
    constexpr double close = 1e-3, rounding = 1e-6; // of h
    struct Foot {
        std::uint32_t cell;
        Vec3d place;
        double unit;
    };
    std::vector<Foot> feet;
    for (std::size_t i = 0; i < source.count(); ++i) {
        const surface::Evaluationd& at = source.at(i, surface::Need::Gradient);
        const double slopeSq = lengthSq(at.gradient);
        if (cells::valid(at) && std::abs(at.value) <= close * at.unit * std::sqrt(slopeSq))
            feet.push_back({source.cell(i), x - at.gradient * (at.value / slopeSq), at.unit});
    }
    double out = none;
    for (const Foot& each : feet) {
        source.moveTo(each.place);
        if (const std::size_t i = source.find(each.cell);
            i != cells::CellSource::none && isFace(source, i, rounding * each.unit))
            out = std::min(out, distance(x, each.place));
    }
    return out;
}

struct Model {
    explicit Model(const surface::Surface& s)
        : surface(s), cells(cells::CellSurface::of(s)), complex(complexes::Complex::of(s)) {}

    const surface::Surface& surface;
    std::optional<cells::CellSurface> cells;
    std::optional<complexes::Complex> complex;
};

/// Of models with cells: to the local Boolean, where several of them are near; of complexes to the nearest cell. For
/// one thread.
class DistanceTo {
  public:
    explicit DistanceTo(const Model& model) : m_model(model) {
        if (model.cells)
            m_source.emplace(*model.cells);
    }

    double operator()(const Vec3d& x, const surface::OrientationHint& hint) {
        if (m_model.complex) {
            const complexes::CellFoot foot = project(*m_model.complex, x, surface::Projector::Almost);
            return foot.ok() ? distance(x, foot.position) : none;
        }
        if (m_source) {
            m_source->moveTo(x);
            if (m_source->count() > 1)
                return toCells(x);
        }
        return distanceTo(m_model.surface, x, hint);
    }

  private:
    double toCells(const Vec3d& x) {
        if (const double near = byOneEvaluation(*m_source, x); near < none)
            return near;
        const cells::CellFoot found = cells::project(*m_model.cells, x);
        return found.projection.ok() ? distance(x, found.projection.foot) : none;
    }

    const Model& m_model;
    std::optional<cells::CellSource> m_source;
};

/// `each(i, distanceTo)` tells the distance of the i-th place.
template <class Each>
Deviation collect(const surface::Surface& surface, std::size_t n, const base::Progress& progress, const char* what,
                  const Each& each) {
    constexpr std::size_t slab = 1 << 14, grain = 64;
    const Model model(surface);
    std::vector<double> all(n);
    for (std::size_t first = 0; first < n; first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), what);
        base::parallelChunks(std::min(slab, n - first), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            DistanceTo far(model);
            for (std::size_t i = first + begin; i < first + end; ++i)
                all[i] = each(i, far);
        });
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
    return collect(surface, which.size(), progress, "Measuring vertices", [&](std::size_t i, DistanceTo& far) {
        const std::uint32_t v = which[i];
        return far(mesh.positions[v], {mesh.normals.empty() ? base::Vec3f{} : mesh.normals[v]});
    });
}

Deviation faceDeviation(const Mesh& mesh, const surface::Surface& surface, const base::Progress& progress) {
    return collect(surface, mesh.triangles.size(), progress, "Measuring faces", [&](std::size_t f, DistanceTo& far) {
        const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[f][k]]; };
        const Vec3d centre = (at(0) + at(1) + at(2)) / 3;
        const Vec3d across = base::normalized(cross(at(1) - at(0), at(2) - at(0)));
        return far(centre, {base::cast<float>(across)});
    });
}

} // namespace mesh
