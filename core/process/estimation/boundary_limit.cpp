#include "core/process/estimation/boundary_limit.h"

#include "core/base/parallel.h"
#include "core/process/estimation/closed_rims.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <numbers>

namespace process {

namespace {

constexpr std::size_t mostSamples = 20000; ///< a quantile of 1 % needs no more
constexpr float pi = std::numbers::pi_v<float>;
constexpr float closedGap = pi / 2; ///< a neighbourhood with no larger gap is closed
/// Who may lie at a rim: a sample of one looks into nearly half a plane of nothing, and o is 0.13 h on the last row of
/// a straight one (process/README 3), 0.1 h on a narrow strip.
constexpr float rimGap = 2 * pi / 3, rimOffCentre = 0.08f;
/// Who does: beyond a rim o grows to any limit within 0.3 h, while noise, tips and sharp edges have their maximum.
constexpr float loosest = 0.45f, tightest = 0.15f, rimReach = 0.8f;
/// Rims shorter than this part of sqrt(n) spacings, some 1/18 of a half-sphere's, count as chance; measured on closed
/// scans (0 to 0.19) and on open ones (from 0.28: small holes in an elephant, and under the Stanford bunny 0.53).
constexpr double shortestRim = 0.22;
/// Of what looks like rims, the part that must be: winding numbers go wrong at one in ten between fins that are as near
/// each other as they are thin.
constexpr double leastShare = 0.1;
constexpr float bandLimit = 0.3f; ///< for bands so narrow that all their samples see a rim
/// By chance alone P(o > L) = exp(-(L / rms)^2). The 99 % quantile of closed neighbourhoods tells rms; this
/// times that is what one sample in 1e5 exceeds: (6) of process/README 3. (1.3 is what one in 2400 exceeds: a handful
/// of pinholes in every scan.)
constexpr float rareOverQuantile = 1.58f; // sqrt(ln 1e5 / ln 100)

/// Surfels at equal distances in tree order.
std::vector<base::Vec3f> samplePositions(const tree::SurfelTree& tree) {
    const std::size_t stride = (tree.size() + mostSamples - 1) / mostSamples;
    std::vector<base::Vec3f> out;
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot, ++at)
            if (at % stride == 0)
                out.push_back(block.position(slot));
    });
    return out;
}

/// Largest angle without a sample in the tangent plane, among those with weight at `x` that lie on the same sheet.
float angularGap(const tree::SurfelTree& tree, const base::Vec3f& x, const base::Vec3f& normal,
                 std::vector<float>& angles) {
    const base::Vec3f u = base::perpendicular(normal), v = base::cross(normal, u);
    const bool normals = tree.layout()->normals, oriented = tree.layout()->oriented;
    angles.clear();
    tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
        for (int slot = begin; slot < end; ++slot) {
            const base::Vec3f q = block.position(slot) - x;
            const float a = base::dot(q, u), b = base::dot(q, v), reach = block.support(slot);
            const float agrees = base::dot(block.normal(slot), normal);
            if (base::lengthSq(q) < reach * reach && a * a + b * b > 1e-6f * reach * reach &&
                (!normals || (oriented ? agrees : std::abs(agrees)) > 0.5f))
                angles.push_back(std::atan2(b, a));
        }
    });
    if (angles.empty())
        return 2 * pi;
    std::sort(angles.begin(), angles.end());
    float gap = angles.front() + 2 * pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
        gap = std::max(gap, angles[i] - angles[i - 1]);
    return gap;
}

struct Sample {
    float offCentre; ///< in units of h
    float gap;
    base::Vec3f foot, normal;
};

std::vector<Sample> look(const surface::Surface& surface, std::span<const base::Vec3f> x,
                         const base::Progress& progress) {
    surface::ProjectOptions options;
    options.projector = surface::Projector::Basic;
    options.tolerance = 1e-4;
    options.checkBoundary = false;
    constexpr std::size_t slab = 2048;
    std::vector<Sample> out(x.size(), {0, std::numeric_limits<float>::quiet_NaN(), {}, {}}); // neither open nor closed
    std::vector<surface::Projection<float>> feet(slab);
    for (std::size_t from = 0; from < x.size(); from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(x.size()), "Looking for boundaries");
        const std::size_t n = std::min(slab, x.size() - from);
        surface::project(surface, x.subspan(from, n), options, std::span(feet).first(n));
        base::parallelChunks(n, 128, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<float> angles;
            for (std::size_t i = begin; i < end; ++i)
                if (feet[i].ok())
                    out[from + i] = {feet[i].at.offCentre / feet[i].at.unit,
                                     angularGap(surface.tree(), x[from + i], feet[i].at.normal, angles), feet[i].foot,
                                     feet[i].at.normal};
        });
    }
    return out;
}

/// A sample beside what looks like a rim for the loosest limit.
struct Beside {
    const Sample* sample;
    surface::BoundaryPoint rim;
};

std::vector<Beside> besideRims(const surface::Surface& surface, std::span<const Sample> samples) {
    surface::SurfaceDefinition definition = surface.definition();
    definition.boundaryLimit = loosest;
    const surface::Surface loose(surface.tree(), definition);
    std::vector<Beside> found(samples.size());
    base::parallelFor(samples.size(), 64, [&](std::size_t i) {
        if (!(samples[i].gap >= rimGap && samples[i].offCentre > rimOffCentre))
            return;
        const base::Vec3d foot = base::cast<double>(samples[i].foot);
        const surface::BoundarySearch rim = surface::findBoundaryPoint(loose, foot);
        if (rim.ok() && distance(rim.point.position, foot) < double(rimReach) * rim.point.unit)
            found[i] = {&samples[i], rim.point};
    });
    std::erase_if(found, [](const Beside& each) { return !each.sample; });
    return found;
}

/// Those beyond which no solid goes on.
std::size_t countOpen(const surface::Surface& surface, std::span<const Beside> beside, const base::Progress& progress) {
    const ClosedRims closed(surface, progress);
    std::vector<char> open(beside.size());
    base::parallelFor(beside.size(), 64, [&](std::size_t i) {
        const Sample& sample = *beside[i].sample;
        open[i] = !closed.closedAt(beside[i].rim, base::cast<double>(sample.foot), base::cast<double>(sample.normal));
    });
    return static_cast<std::size_t>(std::count(open.begin(), open.end(), 1));
}

/// Whether enough samples have a rim beside them.
bool hasRim(const surface::Surface& surface, std::span<const Sample> samples, const base::Progress& progress) {
    const double sampled = static_cast<double>(samples.size()), all = static_cast<double>(surface.tree().size());
    const double least = std::max(3.0, shortestRim * sampled / std::sqrt(all));
    const std::vector<Beside> beside = besideRims(surface, samples);
    const auto looks = static_cast<double>(beside.size());
    if (looks < least || !surface.tree().layout()->oriented)
        return looks >= least;
    return static_cast<double>(countOpen(surface, beside, progress)) >= std::max(least, leastShare * looks);
}

} // namespace

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress) {
    const std::vector<base::Vec3f> x = samplePositions(surface.tree());
    const std::vector<Sample> samples = look(surface, x, part(progress, 0, 0.7));

    std::vector<float> closed;
    for (const Sample& s : samples)
        if (s.gap < closedGap)
            closed.push_back(s.offCentre);
    if (!hasRim(surface, samples, part(progress, 0.7, 1)))
        return std::numeric_limits<float>::infinity();
    if (closed.empty())
        return bandLimit;
    const auto quantile = closed.begin() + static_cast<std::ptrdiff_t>((closed.size() - 1) * 99 / 100);
    std::nth_element(closed.begin(), quantile, closed.end());
    return std::clamp(rareOverQuantile * *quantile, tightest, loosest);
}

} // namespace process
