#include "core/solid/extrude/crossings.h"

#include "core/base/parallel.h"
#include "core/surface/definition.h"
#include "core/surface/rays/intersect.h"
#include "core/surface/rims.h"

namespace solid {

using base::Vec3d, base::Vec3f;

namespace {

/// So many spacings from where a ray begins the surfaces at a border still go over into each other.
constexpr float clear = 1.5f;

class Rays {
  public:
    void add(const Vec3d& from, const Vec3d& way, double spacing) {
        const auto begin = clear * static_cast<float>(spacing), end = static_cast<float>(length(way));
        if (begin < end)
            m_rays.push_back({{base::cast<float>(from), base::cast<float>(normalized(way))}, begin, end});
    }
    void meet(const surface::Surface& surface, Crossings& out) const {
        std::vector<std::uint8_t> hit(m_rays.size());
        base::parallelFor(hit.size(), 64, [&](std::size_t i) {
            surface::IntersectOptions options;
            options.tMin = m_rays[i].begin, options.tMax = m_rays[i].end;
            hit[i] = intersectAny(surface, m_rays[i].ray, options);
        });
        for (std::size_t i = 0; i < hit.size(); ++i)
            if (hit[i] && out.rays++ == 0)
                out.place = base::cast<double>(m_rays[i].ray.origin);
        out.of += hit.size();
    }

  private:
    struct Stretch {
        base::Rayf ray;
        float begin, end;
    };
    std::vector<Stretch> m_rays;
};

/// Walls that go on flat from a face may lie on the next one instead of crossing it: half way up they tell.
void lieOn(const surface::Surface& surface, std::span<const LoopPoint> from, const Vec3d& way, Crossings& out) {
    constexpr float onto = 0.3f; // spacings
    std::vector<Vec3f> places;
    std::vector<float> spacings;
    for (const LoopPoint& p : from)
        if (length(way) > 2 * static_cast<double>(clear) * p.spacing) {
            places.push_back(base::cast<float>(p.position + way * 0.5));
            spacings.push_back(static_cast<float>(p.spacing));
        }
    std::vector<surface::Evaluationf> at(places.size());
    surface.evaluate(places, surface::Need::Gradient, at);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (surface::isSurface(at[i]) && !surface::isPastEnd(surface, places[i], at[i].offCentre, at[i].unit) &&
            std::abs(at[i].value) < onto * spacings[i] && out.rays++ == 0)
            out.place = base::cast<double>(places[i]);
    out.of += places.size();
}

} // namespace

Crossings crossingsOf(const Drawn& drawn, const base::Progress& progress) {
    progress.step(0, "Looking for what is in the way");
    Rays ahead, back;
    std::vector<LoopPoint> walls;
    drawn.part.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            ahead.add(base::cast<double>(block.position(slot)), drawn.way,
                      static_cast<double>(block.support(slot)) * surface::spacingOfUnit);
    });
    for (std::size_t l = 0; l < drawn.borders.size(); ++l)
        for (std::size_t i = 0; i < drawn.borders[l].size(); ++i)
            if (drawn.stands[l][i]) {
                const LoopPoint& p = drawn.borders[l].points[i];
                ahead.add(p.position, drawn.way, p.spacing);
                back.add(p.position, -drawn.way, p.spacing);
                walls.push_back(p);
            }
    Crossings out;
    ahead.meet(drawn.rest, out);
    progress.step(0.5, "Looking for what is in the way");
    back.meet(drawn.part, out);
    lieOn(drawn.rest, walls, drawn.way, out);
    return out;
}

Crossings crossingsOf(const surface::Surface& surface, const Loop& loop, std::span<const Vec3d> ways) {
    Rays rays;
    for (std::size_t i = 0; i < loop.size(); ++i)
        rays.add(loop.points[i].position, ways[i], loop.points[i].spacing);
    Crossings out;
    rays.meet(surface, out);
    return out;
}

} // namespace solid
