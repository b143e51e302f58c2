#include "core/raycast/illuminate.h"

#include "core/base/parallel.h"
#include "core/base/srgb.h"
#include "core/raycast/blocking.h"
#include "core/raycast/edge_aware_filter.h"
#include "core/raycast/light_paths.h"
#include "core/raycast/optics.h"

#include <algorithm>

namespace raycast {

using base::Vec3f;

namespace {

/// Samples between two reports of progress.
constexpr std::size_t batchSize = 32768;

float brightness(const Vec3f& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

Vec3f linear(surfel::Colour colour) {
    const auto channel = [&](int k) { return base::linearOf(static_cast<float>(colour >> (8 * k) & 255u) / 255); };
    return {channel(0), channel(1), channel(2)};
}

class Illumination {
  public:
    Illumination(const LightScene& scene, const SeenSamples& seen, LightCounts& counts, const base::Progress& progress)
        : m_scene(scene), m_seen(seen), m_counts(counts), m_progress(progress),
          m_row(materialRow(scene.lighting.material)), m_lamps(scene.environment.lamps()),
          m_points(seen.samples.size()) {}

    void run(std::span<Lit> out) {
        inBatches(0, 0.1, "finding where light falls", [&](std::size_t begin, std::size_t count) {
            findLightPoints(m_scene, m_seen, begin, std::span(m_points).subspan(begin, count));
        });
        if (m_scene.lighting.shadows)
            shadows();
        if (m_scene.lighting.occlusion)
            occlusion();
        if (m_row.specular())
            paths();
        base::parallelFor(out.size(), 1024, [&](std::size_t i) { out[i] = litAt(i); });
    }

  private:
    template <class Fn>
    void inBatches(double from, double to, const char* what, const Fn& fn) {
        const std::size_t n = m_points.size();
        for (std::size_t begin = 0; begin < n; begin += batchSize) {
            m_progress.step(from + (to - from) * static_cast<double>(begin) / static_cast<double>(n), what);
            fn(begin, std::min(batchSize, n - begin));
        }
    }
    void shadows() {
        const bool anySoft = std::any_of(m_lamps.begin(), m_lamps.end(), [](const Lamp& l) { return l.soft(); });
        m_shadows.assign(m_lamps.size(), std::vector<float>(m_points.size(), 1.0f));
        std::vector<float> some;
        inBatches(0.1, 0.5, "casting shadows", [&](std::size_t begin, std::size_t count) {
            some.resize(count * m_lamps.size());
            findShadows(m_scene, std::span(m_points).subspan(begin, count), rayPatternsOf(m_seen, begin, count), some,
                        m_counts);
            for (std::size_t l = 0; l < m_lamps.size(); ++l)
                std::copy_n(some.begin() + static_cast<std::ptrdiff_t>(l * count), count,
                            m_shadows[l].begin() + static_cast<std::ptrdiff_t>(begin));
        });
        for (std::size_t l = 0; anySoft && l < m_lamps.size(); ++l)
            if (m_lamps[l].soft())
                edgeAwareFilter(m_points, m_seen.width, m_shadows[l]);
    }
    void occlusion() {
        m_open.assign(m_points.size(), 1.0f);
        inBatches(0.5, 0.9, "casting ambient occlusion", [&](std::size_t begin, std::size_t count) {
            findOcclusion(m_scene, std::span(m_points).subspan(begin, count), rayPatternsOf(m_seen, begin, count),
                          std::span(m_open).subspan(begin, count), m_counts);
        });
        edgeAwareFilter(m_points, m_seen.width, m_open);
    }
    void paths() {
        m_light.resize(m_points.size());
        std::vector<Vec3f> directions;
        inBatches(0.5, 1, "following light", [&](std::size_t begin, std::size_t count) {
            directions.resize(count);
            for (std::size_t k = 0; k < count; ++k)
                directions[k] = base::cast<float>(m_seen.ray(begin + k).direction);
            followLight(m_scene, std::span(m_points).subspan(begin, count), directions,
                        std::span(m_light).subspan(begin, count), m_counts);
        });
    }

    float seenOf(std::size_t lamp, std::size_t i) const { return m_shadows.empty() ? 1 : m_shadows[lamp][i]; }
    float openAt(std::size_t i) const { return m_open.empty() ? 1 : m_open[i]; }

    /// Light on a white dull point, with what is in its way and without.
    struct Falling {
        Vec3f light, unhindered;
    };
    Falling falling(std::size_t i, float shadow) const {
        const LightPoint& point = m_points[i];
        const Vec3f room = m_scene.environment.room(point.n);
        Falling out{room * (1 - shadow * (1 - openAt(i))), room};
        for (std::size_t l = 0; l < m_lamps.size(); ++l) {
            const Vec3f light = m_lamps[l].power * std::max(0.0f, dot(point.n, m_lamps[l].direction));
            out.light += light * (1 - shadow * (1 - seenOf(l, i)));
            out.unhindered += light;
        }
        return out;
    }

    Lit litAt(std::size_t i) const {
        const LightPoint& point = m_points[i];
        Lit out;
        out.seen = point.seen;
        if (point.seen == Seen::Ground)
            out.shade = onGround(i);
        else if (point.seen == Seen::Model && m_row.material == Material::Matcap)
            out.shade = onShaded(i);
        else if (point.seen == Seen::Model)
            out.colour = m_row.specular() ? m_light[i] : clay(i);
        return out;
    }
    float onGround(std::size_t i) const {
        const Falling at = falling(i, m_row.shadow);
        const float left = brightness(at.light) / std::max(brightness(at.unhindered), 1e-6f);
        return 1 - m_points[i].fade * (1 - left);
    }
    /// The picture of a lit ball has its own lamps: shadows take part of it only.
    float onShaded(std::size_t i) const {
        constexpr float shadow = 0.85f;
        const Falling at = falling(i, 1);
        const float lamps = brightness(at.unhindered), left = brightness(at.light) / std::max(lamps, 1e-6f);
        return openAt(i) * (1 - shadow) + shadow * left;
    }
    Vec3f clay(std::size_t i) const {
        const LightPoint& point = m_points[i];
        const Sample& sample = m_seen.samples[i];
        constexpr float exponent = 24;
        constexpr Vec3f masked{0.5f, 0.47f, 0.46f}, inside{0.62f, 0.58f, 0.58f};
        Vec3f colour = times(m_row.colour, linear(sample.colour));
        if (point.back)
            colour = times(colour, inside);
        colour = times(colour, Vec3f{1, 1, 1} + (masked - Vec3f{1, 1, 1}) * sample.mask);
        Vec3f out = times(colour, falling(i, 1).light);
        const Vec3f towards = -base::cast<float>(m_seen.ray(i).direction);
        for (std::size_t l = 0; l < m_lamps.size(); ++l) {
            const float c = dot(point.n, normalized(towards + m_lamps[l].direction));
            if (c > 0 && dot(point.n, m_lamps[l].direction) > 0)
                out += m_lamps[l].power * (m_row.gloss * std::pow(c, exponent) * seenOf(l, i));
        }
        return out;
    }

    const LightScene& m_scene;
    const SeenSamples& m_seen;
    LightCounts& m_counts;
    const base::Progress& m_progress;
    const MaterialRow& m_row;
    const std::vector<Lamp>& m_lamps;
    std::vector<LightPoint> m_points;
    std::vector<std::vector<float>> m_shadows; ///< per lamp
    std::vector<float> m_open;
    std::vector<Vec3f> m_light;
};

} // namespace

void illuminate(const LightScene& scene, const SeenSamples& seen, std::span<Lit> out, LightCounts& counts,
                const base::Progress& progress) {
    Illumination(scene, seen, counts, progress).run(out);
}

} // namespace raycast
