#include "core/cells/cell_rays.h"

#include "core/base/parallel.h"
#include "core/cells/cell_roots.h"
#include "core/cells/local_boolean.h"
#include "core/surface/rays/disc_kernel.h"
#include "core/surface/rays/ray_order.h"
#include "core/tree/morton.h"

#include <cassert>
#include <numeric>

namespace cells {

using base::Rayd;
using base::Rayf;
using base::Vec3d;
using surface::IntersectOptions;
using surface::Need;
using surface::RayHit;

namespace {

/// One ray after another. Asks a CellSource or a CellSourcef, which they may share.
template <class Source>
class CellRays {
  public:
    explicit CellRays(Source& source) : m_source(source), m_finder(source.surface()) {}

    void start(const Rayd& ray, const IntersectOptions& options) {
        m_ray = {ray.origin, base::normalized(ray.direction)};
        m_from = static_cast<double>(options.tMin);
        m_to = static_cast<double>(options.tMax);
        m_evaluations = 0;
        m_looked = false;
        m_finder.start(m_ray);
    }
    /// Looks as far as the first disc tells that there is something: is all of that away from creases? How far that
    /// is; nothing where it is not.
    std::optional<double> plainUpTo() {
        look(m_from);
        m_looked = true;
        return m_finder.mixed() ? std::nullopt : std::optional(m_finder.end());
    }
    CellHit first() {
        for (double from = m_from; valid(); from = m_finder.resume()) {
            if (!std::exchange(m_looked, false))
                look(from);
            double nearest = m_finder.end();
            CellHit out;
            findRoots(nearest, [&](const CellHit& hit) {
                if (!out.hit.hit || hit.hit.t < out.hit.t)
                    out = hit;
                nearest = out.hit.t;
                return true;
            });
            if (out.hit.hit || !(m_finder.end() < m_to)) {
                out.hit.evaluations = out.hit.hit ? m_evaluations : 0;
                return out;
            }
        }
        return {};
    }
    /// By ascending t.
    std::vector<CellHit> all() {
        std::vector<CellHit> out;
        if (!valid())
            return out;
        m_finder.look(m_from, m_to, everything);
        double nearest = m_to;
        findRoots(nearest, [&](const CellHit& hit) {
            out.push_back(hit);
            return true;
        });
        std::stable_sort(out.begin(), out.end(), [](const CellHit& a, const CellHit& b) { return a.hit.t < b.hit.t; });
        if (!out.empty())
            out.front().hit.evaluations = m_evaluations;
        dropRepeated(out);
        return out;
    }
    bool any() {
        bool out = false;
        for (double from = m_from; valid() && !out; from = m_finder.resume()) {
            look(from);
            double nearest = m_finder.end();
            findRoots(nearest, [&](const CellHit& hit) {
                out = hit.hit.t - m_from > surface::secondaryEpsilon * surface::spacingOfUnit * hit.hit.unit;
                return !out;
            });
            if (!(m_finder.end() < m_to))
                break;
        }
        return out;
    }

  private:
    static constexpr double everything = std::numeric_limits<double>::infinity();

    bool valid() const { return lengthSq(m_ray.direction) > 0; }
    void look(double from) {
        constexpr double ahead = 1; // h beyond the first disc, where the sharp surface mostly is
        m_finder.look(from, m_to, ahead);
    }
    /// fn(hit) of what is surface up to `nearest`, which may come nearer meanwhile; it returns false to stop. Where
    /// there is one zero at most it costs little; the others are marched no farther than the nearest hit so far.
    template <class Fn>
    void findRoots(const double& nearest, const Fn& fn) {
        CellRoots<Source> roots(m_source, m_ray);
        bool more = true;
        for (const bool monotone : {true, false})
            for (Stretch each : m_finder.found()) {
                if (!more || each.first > nearest)
                    break;
                if (each.monotone() != monotone)
                    continue;
                if (!monotone)
                    each.last = std::min(each.last, nearest);
                m_roots.clear();
                roots.find(each, m_roots);
                for (const double t : m_roots)
                    if (more && t >= m_from && t <= nearest)
                        if (const auto hit = accept(each.cell, t))
                            more = fn(*hit);
            }
        m_evaluations += roots.evaluations();
    }
    std::optional<CellHit> accept(std::uint32_t cell, double t) {
        m_source.moveTo(m_ray.at(t));
        const std::size_t i = m_source.find(cell);
        if (i == Source::none)
            return std::nullopt;
        const auto& at = m_source.at(i, Need::Gradient);
        if (!cells::valid(at) || !isFace(m_source, i, cutTolerance(m_source, at.unit, length(m_source.position()))))
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
    /// Hits that are the same place: where the ray goes through a seam, both its cells have one; and where the sums of
    /// two cells are nearly the same, as beside creases that are flat or fade, both have one that nothing cuts off. No
    /// surface is passed twice from the same side.
    void dropRepeated(std::vector<CellHit>& hits) const {
        constexpr double sameSide = 0.5; // spacings
        const auto facing = [&](const CellHit& hit) { return dot(hit.hit.outward, m_ray.direction) > 0; };
        const auto same = [&](const CellHit& a, const CellHit& b) {
            const double gap = (b.hit.t - a.hit.t) / (surface::spacingOfUnit * b.hit.unit);
            return gap < surface::secondaryEpsilon || (gap < sameSide && a.cell != b.cell && facing(a) == facing(b));
        };
        hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
    }

    Source& m_source;
    StretchFinder m_finder;
    Rayd m_ray;
    double m_from = 0, m_to = 0;
    int m_evaluations = 0;
    bool m_looked = false; ///< from m_from on, and what was found is there
    std::vector<double> m_roots;
};

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

/// Did cells find the place at t, too? Where only one of them is there the smooth surface's bits stay.
template <class T>
bool samePlace(double t, double unit, const RayHit<T>& plain) {
    constexpr double tolerance = 1e-4; // of h: what float leaves at grazing angles
    return plain.hit && std::abs(static_cast<double>(plain.t) - t) <= tolerance * unit;
}

} // namespace

CellHit intersectCells(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    CellSource source(surface);
    CellRays rays(source);
    rays.start(ray, options);
    return rays.first();
}

std::vector<CellHit> intersectAllCells(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    CellSource source(surface);
    CellRays rays(source);
    rays.start(ray, options);
    return rays.all();
}

RayHit<double> intersectReference(const CellSurface& surface, const Rayd& ray, const IntersectOptions& options) {
    const RayHit<double> plain = intersectReference(surface.surface(), ray, options);
    if (!concerns(surface, ray, plain, options))
        return plain;
    const CellHit byCells = intersectCells(surface, ray, options);
    return byCells.alone && samePlace(byCells.hit.t, byCells.hit.unit, plain) ? plain : byCells.hit;
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
    CellRays rays(source);
    rays.start(ray, options);
    return rays.any();
}

namespace {

constexpr std::size_t shared = 512; ///< rays that share what is collected about them

/// Where rays from anywhere first meet a disc, or begin.
std::vector<base::Vec3f> places(const CellSurface& surface, std::span<const Rayf> rays, float tMin) {
    constexpr std::size_t packet = 32;
    const tree::SurfelTree& tree = surface.surface().tree();
    const base::Box3f box = tree.bounds();
    std::vector<base::Vec3f> out(rays.size());
    base::parallelChunks(rays.size(), packet, [&](std::size_t begin, std::size_t end, std::size_t) {
        Rayf some[packet];
        surface::DiscHit discs[packet];
        for (std::size_t i = begin; i < end; ++i)
            some[i - begin] = {rays[i].origin, base::normalized(rays[i].direction)};
        surface::nearestDiscs(tree, {some, end - begin},
                              {tMin, std::numeric_limits<float>::infinity(), tree.maxSupport()}, {discs, end - begin});
        for (std::size_t i = begin; i < end; ++i) {
            const surface::DiscHit& disc = discs[i - begin];
            const base::Vec3f x = disc.crossed() ? some[i - begin].at(disc.nearest) : rays[i].origin;
            out[i] = {std::clamp(x.x, box.lo.x, box.hi.x), std::clamp(x.y, box.lo.y, box.hi.y),
                      std::clamp(x.z, box.lo.z, box.hi.z)};
        }
    });
    return out;
}

/// Rays in an order in which neighbours share what is collected about them.
std::vector<std::uint32_t> orderOf(const CellSurface& surface, std::span<const Rayf> rays, float tMin) {
    const base::Box3f box = surface.surface().tree().bounds();
    std::vector<std::uint32_t> out = surface::viewOrder(rays, box);
    if (!out.empty())
        return out;
    if (rays.size() > shared && !surface::oneView(rays))
        return tree::sortedIndices(places(surface, rays, tMin), box);
    out.resize(rays.size());
    std::iota(out.begin(), out.end(), 0u);
    return out;
}

/// fn(i, rays) for the rays of a list, in parallel.
template <class Fn>
void forCellRays(const CellSurface& surface, std::span<const std::uint32_t> list, const Fn& fn) {
    base::parallelChunks(list.size(), shared, [&](std::size_t begin, std::size_t end, std::size_t) {
        CellSourcef source(surface);
        CellRays rays(source);
        for (std::size_t k = begin; k < end; ++k)
            fn(list[k], rays);
    });
}

/// Those of a list for which `is(i)`.
template <class Is>
std::vector<std::uint32_t> chosen(std::span<const std::uint32_t> list, const Is& is) {
    std::vector<std::uint32_t> out;
    std::copy_if(list.begin(), list.end(), std::back_inserter(out), is);
    return out;
}

/// What the surface without cells says of the rays of a list.
template <class Hit, class Ask>
std::vector<Hit> plainly(std::span<const Rayf> rays, std::span<const std::uint32_t> list, const Ask& ask) {
    std::vector<Rayf> some;
    some.reserve(list.size());
    for (const std::uint32_t i : list)
        some.push_back(rays[i]);
    std::vector<Hit> out(list.size());
    ask(some, out);
    return out;
}

/// Asks the surface without cells where creases have no say in the whole way, and cells elsewhere.
template <class Hit, class Plain, class Fn>
void byConcern(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
               std::span<Hit> out, const Plain& plain, const Fn& byCells) {
    constexpr std::size_t grain = 64;
    std::vector<std::uint8_t> concerned(rays.size());
    base::parallelFor(rays.size(), grain, [&](std::size_t i) {
        concerned[i] = concerns(surface, rays[i], RayHit<float>(), options) ? 1 : 0;
    });
    const std::vector<std::uint32_t> order = orderOf(surface, rays, options.tMin);
    const auto others = chosen(order, [&](std::uint32_t i) { return concerned[i] == 0; });
    std::vector<Hit> found = plainly<Hit>(rays, others, plain);
    for (std::size_t k = 0; k < others.size(); ++k)
        out[others[k]] = std::move(found[k]);
    forCellRays(surface, chosen(order, [&](std::uint32_t i) { return concerned[i] != 0; }),
                [&](std::uint32_t i, CellRays<CellSourcef>& cellRays) {
                    cellRays.start(widened(rays[i]), options);
                    out[i] = byCells(cellRays);
                });
}

} // namespace

void intersect(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
               std::span<RayHit<float>> out) {
    assert(rays.size() == out.size());
    const std::vector<std::uint32_t> order = orderOf(surface, rays, options.tMin);
    struct Known {
        bool byCells = false, alone = false;
        double t = 0, plainUpTo = 0;
    };
    std::vector<Known> known(rays.size());
    const auto askCells = [&](std::uint32_t i, CellRays<CellSourcef>& cellRays) {
        const CellHit hit = cellRays.first();
        known[i] = {true, hit.alone, hit.hit.t, 0};
        out[i] = rounded(hit.hit);
    };
    const auto plainIsThere = [&](std::uint32_t i, const RayHit<float>& plain) {
        return known[i].alone && samePlace(known[i].t, static_cast<double>(out[i].unit), plain);
    };
    forCellRays(surface, order, [&](std::uint32_t i, CellRays<CellSourcef>& cellRays) {
        cellRays.start(widened(rays[i]), options);
        if (const auto end = cellRays.plainUpTo())
            known[i].plainUpTo = *end;
        else
            askCells(i, cellRays);
    });
    const auto maybePlain = chosen(order, [&](std::uint32_t i) { return !known[i].byCells || known[i].alone; });
    const auto plain = plainly<RayHit<float>>(rays, maybePlain, [&](std::span<const Rayf> some, auto& hits) {
        surface::intersect(surface.surface(), some, options, hits);
    });
    std::vector<std::uint32_t> late;
    for (std::size_t k = 0; k < maybePlain.size(); ++k) {
        const std::uint32_t i = maybePlain[k];
        if (!known[i].byCells || plainIsThere(i, plain[k]))
            out[i] = plain[k];
        const double end =
            plain[k].hit ? static_cast<double>(plain[k].t + plain[k].unit) : static_cast<double>(options.tMax);
        if (!known[i].byCells && known[i].plainUpTo < end && concerns(surface, rays[i], plain[k], options))
            late.push_back(i);
    }
    forCellRays(surface, late, [&](std::uint32_t i, CellRays<CellSourcef>& cellRays) {
        const RayHit<float> smooth = out[i];
        cellRays.start(widened(rays[i]), options);
        askCells(i, cellRays);
        if (plainIsThere(i, smooth))
            out[i] = smooth;
    });
}

void intersectAll(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                  std::span<std::vector<RayHit<float>>> out) {
    assert(rays.size() == out.size());
    byConcern(
        surface, rays, options, out,
        [&](std::span<const Rayf> some, auto& hits) { intersectAll(surface.surface(), some, options, hits); },
        [](CellRays<CellSourcef>& cellRays) {
            std::vector<RayHit<float>> hits;
            for (const CellHit& each : cellRays.all())
                hits.push_back(rounded(each.hit));
            return hits;
        });
}

void intersectAny(const CellSurface& surface, std::span<const Rayf> rays, const IntersectOptions& options,
                  std::span<std::uint8_t> out) {
    assert(rays.size() == out.size());
    byConcern(
        surface, rays, options, out,
        [&](std::span<const Rayf> some, auto& hits) { intersectAny(surface.surface(), some, options, hits); },
        [](CellRays<CellSourcef>& cellRays) { return static_cast<std::uint8_t>(cellRays.any() ? 1 : 0); });
}

} // namespace cells
