#include "core/raycast/blocking.h"

#include "core/raycast/directions.h"

#include <algorithm>

namespace raycast {

using base::Vec3f;

/// Cut models are asked for the first hit, which may be one that is cut away; rays leave what is kept only once.
static void findBlockedCut(const LightScene& scene, std::span<const base::Rayf> rays, float reach,
                           std::span<std::uint8_t> out) {
    std::vector<surface::RayHit<float>> hits(rays.size());
    surface::intersect(scene.surface, rays, {}, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const base::Rayd ray{base::cast<double>(rays[i].origin), base::cast<double>(rays[i].direction)};
        const double end = std::min(double(reach), keptPart(ray, scene.clips).second);
        out[i] = hits[i].hit && double(hits[i].t) < end ? 1 : 0;
    }
}

void findBlocked(const LightScene& scene, std::span<const base::Rayf> rays, float reach, std::span<std::uint8_t> out) {
    if (!scene.clips.empty())
        return findBlockedCut(scene, rays, reach, out);
    surface::IntersectOptions options;
    options.tMax = reach;
    surface::intersectAny(scene.surface, rays, options, out);
}

Looks looksOf(const SeenSamples& seen, std::size_t begin, std::size_t count) {
    Looks out;
    out.factor = seen.width > 0 ? 1 : 2;
    out.pattern.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto i = static_cast<int>(begin + k);
        out.pattern[k] =
            static_cast<std::uint8_t>(seen.width > 0 ? patternOf(i % seen.width, i / seen.width) : i % (patterns / 2));
    }
    return out;
}

bool asksForLight(const LightScene& scene, const Place& place) {
    return place.seen == Seen::Ground ||
           (place.seen == Seen::Model && !materialRow(scene.lighting.material).specular());
}

/// Rays of some places, and the sum of what they found at each.
class RayFan {
  public:
    void add(std::size_t place, const base::Rayf& ray) {
        m_places.push_back(static_cast<std::uint32_t>(place));
        m_rays.push_back(ray);
    }
    /// Calls fn(place) for every ray that is blocked; returns the number of rays and forgets them.
    template <class Fn>
    std::size_t forBlocked(const LightScene& scene, float reach, const Fn& fn) {
        m_blocked.resize(m_rays.size());
        findBlocked(scene, m_rays, reach, m_blocked);
        for (std::size_t k = 0; k < m_rays.size(); ++k)
            if (m_blocked[k])
                fn(m_places[k]);
        const std::size_t count = m_rays.size();
        m_places.clear(), m_rays.clear();
        return count;
    }

  private:
    std::vector<std::uint32_t> m_places;
    std::vector<base::Rayf> m_rays;
    std::vector<std::uint8_t> m_blocked;
};

void findShadows(const LightScene& scene, std::span<const Place> places, const Looks& looks, std::span<float> out,
                 LightCounts& counts) {
    constexpr float everywhere = std::numeric_limits<float>::infinity();
    std::fill(out.begin(), out.end(), 1.0f);
    RayFan fan;
    const std::vector<Lamp>& lamps = scene.environment.lamps();
    for (std::size_t l = 0; l < lamps.size(); ++l) {
        const std::span<float> seen = out.subspan(l * places.size(), places.size());
        const int count = lamps[l].soft() ? looks.factor * std::max(1, scene.lighting.shadowRays) : 1;
        const float sine = std::sin(lamps[l].radius);
        for (int j = 0; j < count; ++j) {
            for (std::size_t i = 0; i < places.size(); ++i) {
                const Place& place = places[i];
                const Vec3f d = lamps[l].soft()
                                    ? around(lamps[l].direction, unitPlace(looks.pattern[i], j, count), sine)
                                    : lamps[l].direction;
                if (asksForLight(scene, place) && dot(place.n, d) > 0)
                    fan.add(i, {startBeside(place, place.n), d});
            }
            counts.shadowRays +=
                fan.forBlocked(scene, everywhere, [&](std::size_t i) { seen[i] -= 1 / static_cast<float>(count); });
        }
    }
}

void findOcclusion(const LightScene& scene, std::span<const Place> places, const Looks& looks, std::span<float> out,
                   LightCounts& counts) {
    std::fill(out.begin(), out.end(), 1.0f);
    const float reach = scene.lighting.occlusionReach * scene.size;
    const int count = looks.factor * std::max(1, scene.lighting.occlusionRays);
    const float each = 1 / static_cast<float>(count);
    RayFan fan;
    for (int j = 0; j < count; ++j) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Place& place = places[i];
            if (!asksForLight(scene, place))
                continue;
            const Vec3f d = around(place.n, unitPlace(looks.pattern[i], j, count), 1);
            if (place.seen == Seen::Model && scene.ground) {
                const float fall = -dot(base::cast<float>(scene.ground->normal), d);
                const auto height = static_cast<float>(scene.ground->distance(base::cast<double>(place.x)));
                if (fall > 0 && height < reach * fall) {
                    out[i] -= each;
                    continue;
                }
            }
            fan.add(i, {startBeside(place, place.n), d});
        }
        counts.occlusionRays += fan.forBlocked(scene, reach, [&](std::size_t i) { out[i] -= each; });
    }
}

} // namespace raycast
