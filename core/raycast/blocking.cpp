#include "core/raycast/blocking.h"

#include "core/raycast/directions.h"

#include <algorithm>

namespace raycast {

using base::Vec3f;

/// Takes the first hit, which may be one that is cut away: a ray leaves the part that is kept only once.
static void findBlockedCut(const LightScene& scene, std::span<const base::Rayf> rays, float reach,
                           std::span<std::uint8_t> out) {
    std::vector<surface::RayHit<float>> hits(rays.size());
    intersect(scene.surface, rays, {}, hits);
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
    intersectAny(scene.surface, rays, options, out);
}

RayPatterns rayPatternsOf(const SeenSamples& seen, std::size_t begin, std::size_t count) {
    RayPatterns out;
    out.factor = seen.width > 0 ? 1 : 2;
    out.pattern.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto i = static_cast<int>(begin + k);
        out.pattern[k] = static_cast<std::uint8_t>(seen.width > 0 ? patternOf(i % seen.width, i / seen.width)
                                                                  : i % (patternCount / 2));
    }
    return out;
}

bool asksForLight(const LightScene& scene, const LightPoint& point) {
    return point.seen == Seen::Ground ||
           (point.seen == Seen::Model && !materialRow(scene.lighting.material).specular());
}

/// Rays of some points, and the sum of what they found at each.
class RayFan {
  public:
    void add(std::size_t point, const base::Rayf& ray) {
        m_points.push_back(static_cast<std::uint32_t>(point));
        m_rays.push_back(ray);
    }
    /// Calls fn(point) for every ray that is blocked; returns the number of rays and forgets them.
    template <class Fn>
    std::size_t forBlocked(const LightScene& scene, float reach, const Fn& fn) {
        m_blocked.resize(m_rays.size());
        findBlocked(scene, m_rays, reach, m_blocked);
        for (std::size_t k = 0; k < m_rays.size(); ++k)
            if (m_blocked[k])
                fn(m_points[k]);
        const std::size_t count = m_rays.size();
        m_points.clear(), m_rays.clear();
        return count;
    }

  private:
    std::vector<std::uint32_t> m_points;
    std::vector<base::Rayf> m_rays;
    std::vector<std::uint8_t> m_blocked;
};

void findShadows(const LightScene& scene, std::span<const LightPoint> points, const RayPatterns& patterns,
                 std::span<float> out, LightCounts& counts) {
    constexpr float everywhere = std::numeric_limits<float>::infinity();
    std::fill(out.begin(), out.end(), 1.0f);
    RayFan fan;
    const std::vector<Lamp>& lamps = scene.environment.lamps();
    for (std::size_t l = 0; l < lamps.size(); ++l) {
        const std::span<float> seen = out.subspan(l * points.size(), points.size());
        const int count = lamps[l].soft() ? patterns.factor * std::max(1, scene.lighting.shadowRays) : 1;
        const float sine = std::sin(lamps[l].radius);
        for (int j = 0; j < count; ++j) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                const LightPoint& point = points[i];
                const Vec3f d = lamps[l].soft()
                                    ? around(lamps[l].direction, unitSquarePoint(patterns.pattern[i], j, count), sine)
                                    : lamps[l].direction;
                if (asksForLight(scene, point) && dot(point.n, d) > 0)
                    fan.add(i, {secondaryOrigin(point, point.n), d});
            }
            counts.shadowRays +=
                fan.forBlocked(scene, everywhere, [&](std::size_t i) { seen[i] -= 1 / static_cast<float>(count); });
        }
    }
}

void findOcclusion(const LightScene& scene, std::span<const LightPoint> points, const RayPatterns& patterns,
                   std::span<float> out, LightCounts& counts) {
    std::fill(out.begin(), out.end(), 1.0f);
    const float reach = scene.lighting.occlusionReach * scene.size;
    const int count = patterns.factor * std::max(1, scene.lighting.occlusionRays);
    const float each = 1 / static_cast<float>(count);
    RayFan fan;
    for (int j = 0; j < count; ++j) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const LightPoint& point = points[i];
            if (!asksForLight(scene, point))
                continue;
            const Vec3f d = around(point.n, unitSquarePoint(patterns.pattern[i], j, count), 1);
            if (point.seen == Seen::Model && scene.ground) {
                const float fall = -dot(base::cast<float>(scene.ground->normal), d);
                const auto height = static_cast<float>(scene.ground->distance(base::cast<double>(point.x)));
                if (fall > 0 && height < reach * fall) {
                    out[i] -= each;
                    continue;
                }
            }
            fan.add(i, {secondaryOrigin(point, point.n), d});
        }
        counts.occlusionRays += fan.forBlocked(scene, reach, [&](std::size_t i) { out[i] -= each; });
    }
}

} // namespace raycast
