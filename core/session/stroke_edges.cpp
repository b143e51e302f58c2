#include "core/session/stroke_edges.h"

#include "core/base/error.h"
#include "core/base/ranked.h"
#include "core/base/segment.h"
#include "core/cells/creases/draw_crease.h"
#include "core/cells/creases/fade_creases.h"
#include "core/sculpt/contact.h"
#include "core/sculpt/mirror.h"
#include "core/sculpt/stroke/stroke_options.h"
#include "core/surface/projection/project.h"

#include <algorithm>

namespace session {

using base::Vec3d, base::Vec3f;

/// What the option has a say with: the panel's rule, too.
static bool applies(const char* id, const sculpt::StrokeSettings& settings) {
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        if (std::string_view(option.id) == id)
            return option.applies(sculpt::tool(settings.tool), settings);
    return false;
}

bool leavesEdge(const sculpt::StrokeSettings& settings) {
    return settings.edge > 0 && applies("edge", settings);
}

bool fadesEdges(const sculpt::StrokeSettings& settings) {
    return settings.fadeEdges && applies("fade-edges", settings);
}

/// Moves a line to where the surface bends most across it, as far as the brush reached: outwards where it was raised,
/// inwards where it was carved. Under slanting rays the crest lies beside the places that these meet.
class Crest {
  public:
    Crest(const surface::Surface& before, const surface::Surface& surface, float radius)
        : m_before(before), m_surface(surface), m_radius(radius) {}

    std::vector<Vec3d> along(const std::vector<Vec3d>& way) const {
        std::vector<Across> all(way.size());
        for (std::size_t i = 0; i < way.size(); ++i)
            all[i] = across(way, i);
        std::vector<Vec3d> out;
        for (std::size_t i = 0; i < way.size(); ++i) { // one that strays goes with its neighbours
            std::vector<double> near;
            for (std::size_t k = i < 3 ? 0 : i - 3; k < std::min(way.size(), i + 4); ++k)
                if (all[k].found)
                    near.push_back(all[k].offset);
            if (near.empty())
                continue;
            const Vec3d x = way[i] + all[i].side * base::median(near);
            if (const auto foot = footOf(x, all[i].normal))
                out.push_back(base::cast<double>(foot->first));
        }
        return out;
    }

  private:
    struct Across {
        Vec3d side;
        Vec3f normal;
        double offset = 0; ///< along `side`
        bool found = false;
    };
    using Foot = std::pair<Vec3f, Vec3f>; ///< with the unit gradient there

    std::optional<Foot> footOf(const Vec3d& x, const Vec3f& hint) const {
        surface::ProjectOptions options;
        options.need = surface::Need::Gradient;
        const auto found = surface::project(m_surface, base::cast<float>(x), options, {hint});
        if (!found.ok() || !(lengthSq(found.at.gradient) > 0))
            return std::nullopt;
        return Foot{found.foot, normalized(found.at.gradient)};
    }

    Across across(const std::vector<Vec3d>& way, std::size_t i) const {
        Across out;
        const surface::Evaluationf at = m_surface.evaluate(base::cast<float>(way[i]));
        if (!at.ok())
            return out;
        out.normal = normalized(at.gradient);
        const Vec3d ahead = way[std::min(i + 1, way.size() - 1)] - way[i == 0 ? 0 : i - 1];
        out.side = normalized(cross(base::cast<double>(out.normal), ahead));
        const double step = 0.25 * surface::spacingOfUnit * static_cast<double>(at.unit);
        const int steps = static_cast<int>(0.6 * static_cast<double>(m_radius) / step);
        std::vector<std::optional<Foot>> feet;
        for (int k = -steps; k <= steps; ++k)
            feet.push_back(footOf(way[i] + out.side * (k * step), out.normal));
        const surface::Evaluationf was = m_before.evaluate(base::cast<float>(way[i]), surface::Need::Value);
        const double height = was.ok() ? static_cast<double>(was.value) : 0;
        const double raised = std::abs(height) > step ? height : 0; // carved below 0
        double most = -1;
        constexpr std::size_t apart = 4; // a spacing to both sides
        for (std::size_t k = apart; k + apart < feet.size(); ++k) {
            if (!feet[k] || !feet[k - apart] || !feet[k + apart])
                continue;
            const Vec3f& before = feet[k - apart]->second;
            const Vec3f& after = feet[k + apart]->second;
            const double spread = dot(base::cast<double>(after - before), out.side); // > 0 where it stands out
            const double turn = 1 - static_cast<double>(dot(before, after));
            if (turn > most && spread * raised >= 0) {
                most = turn;
                out.offset = dot(base::cast<double>(feet[k]->first) - way[i], out.side);
                out.found = true;
            }
        }
        return out;
    }

    const surface::Surface &m_before, &m_surface;
    float m_radius;
};

/// Of one image of the stroke: a line for each part that meets the model without a break.
static std::vector<std::vector<Vec3d>> waysOf(const surface::Surface& surface, const sculpt::Mirror& image,
                                              std::span<const sculpt::StrokeSample> samples, float least) {
    std::vector<std::vector<Vec3d>> out(1);
    for (const sculpt::StrokeSample& sample : samples) {
        const base::Rayf ray = image.ray(sample.ray);
        const auto touched = sculpt::contact(surface, {ray.origin, normalized(ray.direction)});
        if (!touched) {
            if (!out.back().empty())
                out.emplace_back();
            continue;
        }
        const Vec3d x = base::cast<double>(touched->position);
        if (out.back().empty() || base::distance(x, out.back().back()) > static_cast<double>(least))
            out.back().push_back(x);
    }
    return out;
}

static std::vector<std::vector<Vec3d>> allWays(const surface::Surface& surface, const sculpt::StrokeSettings& settings,
                                               std::span<const sculpt::StrokeSample> samples, const Vec3d& origin) {
    std::vector<std::vector<Vec3d>> out;
    for (const sculpt::Mirror& image : sculpt::mirrors(settings.symmetry, origin))
        for (std::vector<Vec3d>& way : waysOf(surface, image, samples, 0.05f * settings.radius))
            out.push_back(std::move(way));
    return out;
}

surface::Surface withEdges(const surface::Surface& before, const surface::Surface& done,
                           const sculpt::StrokeSettings& settings, std::span<const sculpt::StrokeSample> samples,
                           const Vec3d& origin, std::string& message, const base::Progress& progress) {
    const bool raises = settings.tool == "draw-sharp"; // the others draw together what lies about the way
    const Crest crest(before, done, settings.radius);
    surface::Surface out = before;
    for (const std::vector<Vec3d>& way : allWays(raises ? done : before, settings, samples, origin)) {
        std::vector<Vec3d> line = raises ? std::vector<Vec3d>() : way;
        for (const Vec3d& x : raises ? crest.along(way) : std::vector<Vec3d>())
            if (const auto found = surface::project(before, base::cast<float>(x)); found.ok())
                line.push_back(base::cast<double>(found.foot));
        if (line.size() < 2)
            continue;
        try {
            out = cells::drawCrease(out, line, static_cast<double>(settings.edge), progress).surface;
        } catch (const base::Error& error) {
            message = "no edge was made along the stroke: " + error.message();
        }
    }
    return out;
}

surface::Surface withFadedEdges(const surface::Surface& done, const sculpt::StrokeSettings& settings,
                                std::span<const sculpt::StrokeSample> samples, const Vec3d& origin) {
    const std::vector<std::vector<Vec3d>> ways = allWays(done, settings, samples, origin);
    const auto share = [&](const Vec3f& x) {
        const Vec3d p = base::cast<double>(x);
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::vector<Vec3d>& way : ways)
            for (std::size_t i = 0; i < way.size(); ++i)
                nearest = std::min(
                    nearest, base::distance(p, nearestOnSegment(way[i], way[std::min(i + 1, way.size() - 1)], p)));
        const double r = nearest / static_cast<double>(settings.radius);
        return r < 1 ? static_cast<double>(settings.strength * sculpt::weight(settings.falloff, static_cast<float>(r)))
                     : 0.0;
    };
    return cells::fadeCreases(done, share);
}

} // namespace session
