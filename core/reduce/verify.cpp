#include "core/reduce/verify.h"

#include "core/base/ranked.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/projection/project.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <numbers>

namespace reduce {

namespace {

constexpr std::size_t slab = 1 << 14;
/// A foot farther away than so many supports is another part's: 3 spacings of a reduced set.
constexpr float farthest = 1.9f;
constexpr int fewest = 3;

bool isFoot(const surface::Projection<float>& p, const base::Vec3f& from) {
    const float reach = farthest * p.at.unit;
    return p.ok() && p.at.samples >= fewest && distanceSq(p.foot, from) < reach * reach;
}

/// fn(index, foot) for the feet of a list of positions.
template <class Fn>
void forFeet(const surface::Surface& surface, std::span<const base::Vec3f> from, const base::Progress& progress,
             const Fn& fn) {
    std::vector<surface::Projection<float>> feet(std::min(slab, from.size()));
    for (std::size_t begin = 0; begin < from.size(); begin += slab) {
        progress.step(double(begin) / double(from.size()), "Verifying");
        const std::size_t n = std::min(slab, from.size() - begin);
        surface::project(surface, from.subspan(begin, n), {}, std::span(feet).first(n));
        for (std::size_t k = 0; k < n; ++k)
            fn(begin + k, feet[k]);
    }
}

/// A value that all but a thousandth stay below, and the largest.
void setExtremes(std::vector<float>& distances, Report& report) {
    if (distances.empty())
        return;
    report.p999 = double(base::quantile(distances, 0.999));
    report.max = double(std::ranges::max(distances));
}

/// Samples of the model to the surface.
void verifySamples(const Dense& dense, const surface::Surface& surface, Report& report, Missed& missed,
                   const base::Progress& progress) {
    std::vector<float> distances;
    distances.reserve(dense.feet);
    std::vector<base::Vec3f> from, normal;
    std::vector<std::uint8_t> footed;
    std::size_t done = 0;
    double sum = 0;
    const auto flush = [&] {
        forFeet(surface, from, {{}, progress.cancel}, [&](std::size_t k, const surface::Projection<float>& foot) {
            if (!dense.footed[done + k])
                return;
            if (!isFoot(foot, from[k])) {
                ++report.holes;
                missed.position.push_back(from[k]);
                missed.normal.push_back(normal[k]);
                missed.samples.push_back(foot.at.samples);
                return;
            }
            distances.push_back(distance(foot.foot, from[k]));
            sum += double(distances.back()) * double(distances.back());
            report.leastSupports = std::min(report.leastSupports, foot.at.samples);
        });
        done += from.size();
        from.clear(), normal.clear();
        progress.step(double(done) / double(dense.footed.size()), "Verifying");
    };
    dense.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            from.push_back(block.position(slot)), normal.push_back(block.normal(slot));
        if (from.size() >= slab)
            flush();
    });
    flush();
    if (distances.empty())
        return;
    report.rms = std::sqrt(sum / double(distances.size()));
    setExtremes(distances, report);
}

/// Between the two surfaces; their distances, and how many of the places have no foot.
struct Between {
    std::vector<float> distances;
    std::size_t holes = 0;
};
Between measureBetween(const Places& places, const surface::Surface& surface, Report& report,
                       const base::Progress& progress) {
    Between out;
    out.distances.reserve(places.size());
    double sum = 0, turned = 0;
    forFeet(surface, places.position, progress, [&](std::size_t i, const surface::Projection<float>& foot) {
        if (!isFoot(foot, places.position[i])) {
            ++out.holes;
            return;
        }
        out.distances.push_back(distance(foot.foot, places.position[i]));
        const double d = double(out.distances.back());
        const base::Vec3d g = normalized(base::cast<double>(foot.at.gradient));
        const base::Vec3d v = base::cast<double>(places.normal[i]);
        const double sine = length(cross(g, v)), cosine = dot(g, v);
        const double angle = std::atan2(sine, places.oriented ? cosine : std::abs(cosine));
        sum += d * d, turned += angle * angle;
        report.surfaceMax = std::max(report.surfaceMax, d);
        report.leastSupports = std::min(report.leastSupports, foot.at.samples);
    });
    if (!out.distances.empty()) {
        const double n = double(out.distances.size());
        report.surfaceRms = std::sqrt(sum / n);
        report.normalsDeg = std::sqrt(turned / n) * 180 / std::numbers::pi;
    }
    return out;
}

Report begun(const surface::Surface& surface) {
    Report out;
    out.count = surface.tree().size();
    out.ellipsoids = surfel::shapeChannel(*surface.tree().layout()) > 0;
    out.leastSupports = std::numeric_limits<int>::max();
    return out;
}

Report ended(Report report) {
    if (report.leastSupports == std::numeric_limits<int>::max())
        report.leastSupports = 0;
    return report;
}

} // namespace

Report verifyPlaces(const Places& places, const surface::Surface& surface, const base::Progress& progress) {
    Report out = begun(surface);
    Between between = measureBetween(places, surface, out, progress);
    out.rms = out.surfaceRms;
    out.holes = between.holes;
    setExtremes(between.distances, out);
    return ended(out);
}

Report verify(const Dense& dense, const surface::Surface& surface, Missed& missed, const base::Progress& progress) {
    Report out = begun(surface);
    out.denseRms = dense.rms;
    out.strays = dense.footed.size() - dense.feet;
    verifySamples(dense, surface, out, missed, progress);
    measureBetween(dense.places, surface, out, progress);
    return ended(out);
}

Report verifyAgainst(const surface::Surface& model, const surface::Surface& surface, const base::Progress& progress) {
    Missed missed;
    return verify(denseOf(model, 1, process::part(progress, 0, 0.5)), surface, missed, process::part(progress, 0.5, 1));
}

} // namespace reduce
