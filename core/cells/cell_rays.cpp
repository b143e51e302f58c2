#include "core/cells/cell_rays.h"

#include "core/base/parallel.h"
#include "core/cells/cell_roots.h"
#include "core/cells/local_boolean.h"
#include "core/surface/rays/ray_order.h"
#include "core/tree/morton.h"

#include <cassert>

namespace cells {

using base::Rayd;
using base::Rayf;
using base::Vec3d;
using surface::IntersectOptions;
using surface::Need;
using surface::RayHit;

namespace {

/// What a ray is asked for: its first hit, all of them, or any that is not where it starts.
enum class Wanted { First, All, Any };

/// Asks a CellSource or a CellSourcef, which many rays may share.
template <class Source>
class CellRay {
  public:
    CellRay(Source& source, const Rayd& ray, double from, double to)
        : m_source(source), m_ray{ray.origin, base::normalized(ray.direction)}, m_from(from), m_to(to),
          m_roots(m_source, m_ray) {}

    /// Hits by ascending t.
    std::vector<CellHit> run(Wanted wanted) {
        std::vector<CellHit> out;
        if (!(lengthSq(m_ray.direction) > 0))
            return out;
        double nearest = m_to;
        const bool first = wanted == Wanted::First;
        std::vector<double> roots;
        const std::vector<Stretch> found = stretches(m_source.surface(), m_ray, m_from, m_to);
        // where there is one zero at most it costs little; the others are marched no farther than the nearest hit
        for (const bool monotone : {true, false})
            for (Stretch each : found) {
                if (first && each.first > nearest)
                    break;
                if (each.monotone() != monotone)
                    continue;
                if (first && !monotone)
                    each.last = std::min(each.last, nearest);
                roots.clear();
                m_roots.find(each, roots);
                for (const double t : roots)
                    if (t >= m_from && t <= (first ? nearest : m_to))
                        if (const auto hit = accept(each.cell, t)) {
                            out.push_back(*hit);
                            nearest = std::min(nearest, t);
                            if (wanted == Wanted::Any && !atStart(*hit))
                                return {*hit};
                        }
            }
        if (wanted == Wanted::Any)
            return {};
        std::stable_sort(out.begin(), out.end(), [](const CellHit& a, const CellHit& b) { return a.hit.t < b.hit.t; });
        if (!out.empty())
            out.front().hit.evaluations = m_roots.evaluations();
        return out;
    }

  private:
    bool atStart(const CellHit& at) const {
        return !(at.hit.t - m_from > surface::secondaryEpsilon * surface::spacingOfUnit * at.hit.unit);
    }
    std::optional<CellHit> accept(std::uint32_t cell, double t) {
        m_source.moveTo(m_ray.at(t));
        const std::size_t i = m_source.find(cell);
        if (i == Source::none)
            return std::nullopt;
        const auto& at = m_source.at(i, Need::Gradient);
        if (!valid(at) || !isFace(m_source, i, cutTolerance(m_source, at.unit, length(m_source.position()))))
            return std::nullopt;
        CellHit out;
        out.cell = cell;
        out.alone = m_source.alone();
        out.hit.hit = true;
        out.hit.t = t;
        out.hit.position = m_source.position();
        out.hit.outward = base::normalized(at.gradient);
        out.hit.normal = dot(out.hit.outward, m_ray.direction) > 0 ? -out.hit.outward : out.hit.outward;
        out.hit.unit = at.unit;
        out.hit.agreement = at.agreement;
        return out;
    }

    Source& m_source;
    Rayd m_ray;
    double m_from, m_to;
    CellRoots<Source> m_roots;
};

/// The first hit, if any, no farther than `to`.
template <class Source>
CellHit firstHit(Source& source, const Rayd& ray, double from, double to) {
    const std::vector<CellHit> hits = CellRay(source, ray, from, to).run(Wanted::First);
    return hits.empty() ? CellHit() : hits.front();
}

/// Hits that are the same place: where the ray goes through a seam, both its cells have one.
void dropRepeated(std::vector<CellHit>& hits) {
    const auto same = [](const CellHit& a, const CellHit& b) {
        return b.hit.t - a.hit.t < surface::secondaryEpsilon * surface::spacingOfUnit * b.hit.unit;
    };
    hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
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

template <class Source>
std::vector<CellHit> allHits(Source& source, const Rayd& ray, const IntersectOptions& options) {
    std::vector<CellHit> hits =
        CellRay(source, ray, static_cast<double>(options.tMin), static_cast<double>(options.tMax)).run(Wanted::All);
    dropRepeated(hits);
    return hits;
}

template <class Source>
bool anyHit(Source& source, const Rayd& ray, const IntersectOptions& options) {
    return !CellRay(source, ray, static_cast<double>(options.tMin), static_cast<double>(options.tMax))
                .run(Wanted::Any)
                .empty();
}

} // namespace

CellHit intersectCells(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    CellSource source(surface);
    return firstHit(source, ray, static_cast<double>(options.tMin), static_cast<double>(options.tMax));
}

std::vector<CellHit> intersectAllCells(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    CellSource source(surface);
    return allHits(source, ray, options);
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
    if (!concerns(surface, ray, RayHit<double>(), options))
        return intersectAnyReference(surface.surface(), ray, options);
    CellSource source(surface);
    return anyHit(source, ray, options);
}

/// fn(i, source) for the rays that creases have a say in, neighbours one after the other: they share what is packed
/// about them.
template <class Hit, class Fn>
static void forConcerned(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                         const Hit& hit, const Fn& fn) {
    constexpr std::size_t grain = 64, shared = 512;
    std::vector<std::uint8_t> concerned(rays.size());
    base::parallelFor(rays.size(), grain,
                      [&](std::size_t i) { concerned[i] = concerns(surface, rays[i], hit(i), options) ? 1 : 0; });
    std::vector<std::uint32_t> order = surface::viewOrder(rays, surface.surface().tree().bounds());
    if (order.empty() && rays.size() > shared) { // from anywhere: by where they meet the smooth surface, or begin
        const base::Box3f box = surface.surface().tree().bounds();
        std::vector<base::Vec3f> places(rays.size());
        base::parallelFor(rays.size(), grain, [&](std::size_t i) {
            const RayHit<float>& there = hit(i);
            const base::Vec3f& x = there.hit ? there.position : rays[i].origin;
            places[i] = {std::clamp(x.x, box.lo.x, box.hi.x), std::clamp(x.y, box.lo.y, box.hi.y),
                         std::clamp(x.z, box.lo.z, box.hi.z)};
        });
        order = tree::sortedIndices(places, box);
    }
    std::vector<std::size_t> list;
    for (std::size_t k = 0; k < rays.size(); ++k)
        if (const std::size_t i = order.empty() ? k : order[k]; concerned[i] != 0)
            list.push_back(i);
    base::parallelChunks(list.size(), shared, [&](std::size_t begin, std::size_t end, std::size_t) {
        CellSourcef source(surface);
        for (std::size_t k = begin; k < end; ++k)
            fn(list[k], source);
    });
}

void intersect(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out) {
    assert(rays.size() == out.size());
    constexpr double around = 1; // h about the smooth surface's hit, where the sharp one's mostly is
    intersect(surface.surface(), rays, options, out);
    const auto from = static_cast<double>(options.tMin), to = static_cast<double>(options.tMax);
    forConcerned(
        surface, rays, options, [&](std::size_t i) { return out[i]; },
        [&](std::size_t i, CellSourcef& source) {
            const Rayd ray = widened(rays[i]);
            const double soon = static_cast<double>(out[i].t) + around * static_cast<double>(out[i].unit);
            CellHit found;
            if (out[i].hit && soon < to)
                found = firstHit(source, ray, from, soon);
            if (!found.hit.hit)
                found = firstHit(source, ray, from, to);
            if (!samePlace(found, out[i]))
                out[i] = rounded(found.hit);
        });
}

void intersectAll(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                  std::span<std::vector<RayHit<float>>> out) {
    assert(rays.size() == out.size());
    intersectAll(surface.surface(), rays, options, out);
    forConcerned(
        surface, rays, options, [](std::size_t) { return RayHit<float>(); },
        [&](std::size_t i, CellSourcef& source) {
            out[i].clear();
            for (const CellHit& each : allHits(source, widened(rays[i]), options))
                out[i].push_back(rounded(each.hit));
        });
}

void intersectAny(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                  std::span<std::uint8_t> out) {
    assert(rays.size() == out.size());
    intersectAny(surface.surface(), rays, options, out);
    forConcerned(
        surface, rays, options, [](std::size_t) { return RayHit<float>(); },
        [&](std::size_t i, CellSourcef& source) { out[i] = anyHit(source, widened(rays[i]), options) ? 1 : 0; });
}

} // namespace cells
