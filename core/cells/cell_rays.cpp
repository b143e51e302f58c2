#include "core/cells/cell_rays.h"

#include "core/base/parallel.h"
#include "core/cells/cell_roots.h"
#include "core/cells/local_boolean.h"

#include <cassert>

namespace cells {

using base::Rayd;
using base::Rayf;
using base::Vec3d;
using surface::IntersectOptions;
using surface::Need;
using surface::RayHit;

namespace {

class CellRay {
  public:
    CellRay(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options)
        : m_source(surface), m_ray{ray.origin, base::normalized(ray.direction)}, m_options(options),
          m_roots(m_source, m_ray) {}

    /// Hits by ascending t; the first one alone unless `all`.
    std::vector<CellHit> run(bool all, double from) {
        std::vector<CellHit> out;
        if (!(lengthSq(m_ray.direction) > 0))
            return out;
        const double most = static_cast<double>(m_options.tMax);
        double nearest = most;
        const std::vector<Stretch> found = stretches(m_source.surface(), m_ray, from, most);
        // where there is one zero at most it costs little; the others are marched no farther than the nearest hit
        for (const bool monotone : {true, false})
            for (Stretch each : found) {
                if (!all && each.begin > nearest)
                    break;
                if (each.monotone() != monotone)
                    continue;
                if (!all && !monotone)
                    each.end = std::min(each.end, nearest);
                std::vector<double> roots;
                m_roots.find(each, roots);
                for (const double t : roots)
                    if (t >= from && t <= (all ? most : nearest))
                        if (const auto hit = accept(each.cell, t)) {
                            out.push_back(*hit);
                            nearest = std::min(nearest, t);
                        }
            }
        std::stable_sort(out.begin(), out.end(), [](const CellHit& a, const CellHit& b) { return a.hit.t < b.hit.t; });
        if (!out.empty())
            out.front().hit.evaluations = m_roots.evaluations();
        return out;
    }

  private:
    std::optional<CellHit> accept(std::uint32_t cell, double t) {
        m_source.moveTo(m_ray.at(t));
        const std::size_t i = m_source.find(cell);
        if (i == CellSource::none)
            return std::nullopt;
        const surface::Evaluationd& at = m_source.at(i, Need::Gradient);
        if (!valid(at) || !isFace(m_source, i, cutTolerance(at.unit, length(m_source.position()))))
            return std::nullopt;
        CellHit out;
        out.cell = cell;
        out.alone = m_source.count() == 1;
        out.hit.hit = true;
        out.hit.t = t;
        out.hit.position = m_source.position();
        out.hit.outward = base::normalized(at.gradient);
        out.hit.normal = dot(out.hit.outward, m_ray.direction) > 0 ? -out.hit.outward : out.hit.outward;
        out.hit.unit = at.unit;
        out.hit.agreement = at.agreement;
        return out;
    }

    CellSource m_source;
    Rayd m_ray;
    IntersectOptions m_options;
    CellRoots m_roots;
};

/// Hits that are the same place: where the ray goes through a seam, both its cells have one.
void dropRepeated(std::vector<CellHit>& hits) {
    const auto same = [](const CellHit& a, const CellHit& b) {
        return b.hit.t - a.hit.t < surface::secondaryEpsilon * surface::spacingOfUnit * b.hit.unit;
    };
    hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
}

RayHit<float> rounded(const RayHit<double>& h) {
    RayHit<float> out;
    out.hit = h.hit;
    out.t = static_cast<float>(h.t);
    out.position = base::cast<float>(h.position);
    out.normal = base::cast<float>(h.normal);
    out.outward = base::cast<float>(h.outward);
    out.unit = static_cast<float>(h.unit);
    out.agreement = static_cast<float>(h.agreement);
    out.evaluations = h.evaluations;
    return out;
}

Rayd widened(const Rayf& ray) {
    return {base::cast<double>(ray.origin), base::cast<double>(ray.direction)};
}

/// Does a crease have a say in what the ray meets up to `hit`, or at all where that is none? The surface about the hit
/// belongs to the way.
template <class T>
bool concerns(const CellSurface& surface, const base::Ray<T>& ray, const RayHit<T>& hit,
              const IntersectOptions& options) {
    const Rayf rounded{base::cast<float>(ray.origin), base::normalized(base::cast<float>(ray.direction))};
    return surface.mixedAlong(rounded, hit.hit ? static_cast<float>(hit.t + hit.unit) : options.tMax);
}

/// Did both find the same place, where only one cell is? Then the smooth surface's bits stay.
template <class T>
bool samePlace(const CellHit& byCells, const RayHit<T>& plain) {
    constexpr double tolerance = 1e-4; // of h: what float leaves at grazing angles
    return byCells.alone && plain.hit &&
           std::abs(static_cast<double>(plain.t) - byCells.hit.t) <= tolerance * byCells.hit.unit;
}

bool any(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    for (const CellHit& each : CellRay(surface, ray, options).run(true, static_cast<double>(options.tMin)))
        if (each.hit.t - static_cast<double>(options.tMin) >
            surface::secondaryEpsilon * surface::spacingOfUnit * each.hit.unit)
            return true;
    return false;
}

} // namespace

CellHit intersectCells(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    const std::vector<CellHit> hits = CellRay(surface, ray, options).run(false, static_cast<double>(options.tMin));
    return hits.empty() ? CellHit() : hits.front();
}

std::vector<CellHit> intersectAllCells(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    std::vector<CellHit> hits = CellRay(surface, ray, options).run(true, static_cast<double>(options.tMin));
    dropRepeated(hits);
    return hits;
}

RayHit<double> intersectReference(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    const RayHit<double> plain = intersectReference(surface.surface(), ray, options);
    if (!concerns(surface, ray, plain, options))
        return plain;
    const CellHit byCells = intersectCells(surface, ray, options);
    return samePlace(byCells, plain) ? plain : byCells.hit;
}

std::vector<RayHit<double>> intersectAllReference(const CellSurface& surface, const Rayd& ray,
                                                  const IntersectOptions& options) {
    if (!concerns(surface, ray, RayHit<double>(), options))
        return intersectAllReference(surface.surface(), ray, options);
    std::vector<RayHit<double>> out;
    for (const CellHit& each : intersectAllCells(surface, ray, options))
        out.push_back(each.hit);
    return out;
}

bool intersectAnyReference(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    return concerns(surface, ray, RayHit<double>(), options) ? any(surface, ray, options)
                                                             : intersectAnyReference(surface.surface(), ray, options);
}

void intersect(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out) {
    assert(rays.size() == out.size());
    intersect(surface.surface(), rays, options, out);
    base::parallelFor(rays.size(), 16, [&](std::size_t i) {
        if (!concerns(surface, rays[i], out[i], options))
            return;
        const CellHit byCells = intersectCells(surface, widened(rays[i]), options);
        if (!samePlace(byCells, out[i]))
            out[i] = rounded(byCells.hit);
    });
}

void intersectAll(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                  std::span<std::vector<RayHit<float>>> out) {
    assert(rays.size() == out.size());
    intersectAll(surface.surface(), rays, options, out);
    base::parallelFor(rays.size(), 16, [&](std::size_t i) {
        if (!concerns(surface, rays[i], RayHit<float>(), options))
            return;
        out[i].clear();
        for (const CellHit& each : intersectAllCells(surface, widened(rays[i]), options))
            out[i].push_back(rounded(each.hit));
    });
}

void intersectAny(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                  std::span<std::uint8_t> out) {
    assert(rays.size() == out.size());
    intersectAny(surface.surface(), rays, options, out);
    base::parallelFor(rays.size(), 16, [&](std::size_t i) {
        if (concerns(surface, rays[i], RayHit<float>(), options))
            out[i] = any(surface, widened(rays[i]), options) ? 1 : 0;
    });
}

} // namespace cells
