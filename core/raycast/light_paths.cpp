#include "core/raycast/light_paths.h"

#include "core/raycast/optics.h"

namespace raycast {

using base::Vec3f;

namespace {

struct Path {
    std::uint32_t point = 0; ///< that it adds to
    bool inside = false;
    base::Rayf ray;
    Vec3f weight;
    Vec3f before; ///< direction before it entered, for where it finds no way out
};

float strength(const Vec3f& weight) {
    return std::max({weight.x, weight.y, weight.z});
}

class LightPaths {
  public:
    LightPaths(const LightScene& scene, std::span<Vec3f> out)
        : m_scene(scene), m_row(materialRow(scene.lighting.material)), m_out(out),
          m_absorption(m_row.absorption / scene.size) {}

    /// The surface's part in a ray along d that has met it.
    void meet(std::uint32_t point, const LightPoint& at, const Vec3f& d, Path path) {
        path.point = point;
        if (m_row.material == Material::Metal)
            reflect(at, d, times(path.weight, metalReflectance(-dot(d, at.n), m_row.colour)), path);
        else
            meetGlass(at, d, path);
    }

    void follow(LightCounts& counts) {
        std::vector<surface::RayHit<float>> hits;
        std::vector<base::Rayf> rays;
        for (int bounce = 0; bounce < m_scene.lighting.bounces && !m_next.empty(); ++bounce) {
            m_now.swap(m_next);
            m_next.clear();
            rays.clear();
            for (const Path& path : m_now)
                rays.push_back(path.ray);
            hits.resize(rays.size());
            intersect(m_scene.surface, rays, {}, hits);
            counts.pathRays += rays.size();
            for (std::size_t i = 0; i < m_now.size(); ++i)
                advance(m_now[i], hits[i]);
        }
        for (const Path& path : m_next) // as bright as the room
            add(path, m_scene.environment.room(path.ray.direction));
    }

  private:
    void add(const Path& path, const Vec3f& light) { m_out[path.point] += times(path.weight, light); }

    void advance(const Path& path, const surface::RayHit<float>& hit) {
        const Vec3f& d = path.ray.direction;
        if (!kept(path.ray, hit)) {
            if (path.inside)
                passThrough(path);
            else
                add(path, m_scene.environment.from(d));
            return;
        }
        LightPoint at;
        at.x = hit.position, at.n = hit.normal, at.unit = hit.unit;
        at.back = m_scene.oriented && dot(hit.normal, hit.outward) < 0;
        Path next = path;
        if (path.inside)
            next.weight = times(path.weight, transmitted(m_absorption, hit.t));
        meet(path.point, at, d, next);
    }
    bool kept(const base::Rayf& ray, const surface::RayHit<float>& hit) const {
        if (!hit.hit || m_scene.clips.empty())
            return hit.hit;
        return double(hit.t) <=
               keptPart({base::cast<double>(ray.origin), base::cast<double>(ray.direction)}, m_scene.clips).second;
    }

    /// Entered what has no other side: a pane after all.
    void passThrough(Path path) {
        path.inside = false;
        path.ray.direction = path.before;
        m_next.push_back(path);
    }

    void meetGlass(const LightPoint& at, const Vec3f& d, const Path& path) {
        const float c = -dot(d, at.n);
        const bool leaves = at.back;
        if (!m_scene.oriented || path.inside != leaves)
            return meetPane(at, d, path);
        const float eta = leaves ? m_row.index : 1 / m_row.index;
        const auto through = refracted(d, at.n, eta);
        float back = through ? reflectance(c, eta) : 1;
        if (strength(path.weight) * back < leastPart)
            back = 0;
        if (back > 0)
            reflect(at, d, path.weight * back, path);
        if (!through || !(back < 1))
            return;
        Path next = path;
        next.inside = !leaves;
        next.weight = path.weight * (1 - back);
        next.before = d;
        next.ray = {secondaryOrigin(at, -at.n), *through};
        m_next.push_back(next);
    }
    void meetPane(const LightPoint& at, const Vec3f& d, const Path& path) {
        constexpr float thickness = 0.03f; // of the model's diagonal: what tints a pane
        float back = path.inside ? 0 : paneReflectance(-dot(d, at.n), 1 / m_row.index);
        if (strength(path.weight) * back < leastPart)
            back = 0;
        if (back > 0)
            reflect(at, d, path.weight * back, path);
        Path next = path;
        next.weight = times(path.weight * (1 - back), transmitted(m_row.absorption, thickness));
        next.ray = {secondaryOrigin(at, -at.n), d};
        m_next.push_back(next);
    }
    void reflect(const LightPoint& at, const Vec3f& d, const Vec3f& weight, Path path) {
        path.weight = weight;
        path.ray = {secondaryOrigin(at, at.n), mirrored(d, at.n)};
        m_next.push_back(path);
    }

    const LightScene& m_scene;
    const MaterialRow& m_row;
    std::span<Vec3f> m_out;
    Vec3f m_absorption; ///< per model unit
    std::vector<Path> m_now, m_next;
};

} // namespace

void followLight(const LightScene& scene, std::span<const LightPoint> points, std::span<const Vec3f> directions,
                 std::span<Vec3f> out, LightCounts& counts) {
    LightPaths paths(scene, out);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].seen == Seen::Model) {
            out[i] = {};
            Path path;
            path.weight = {1, 1, 1};
            paths.meet(static_cast<std::uint32_t>(i), points[i], directions[i], path);
        }
    paths.follow(counts);
}

} // namespace raycast
