#include "core/process/boundary_limit.h"

#include "core/base/parallel.h"
#include "core/surface/project.h"

#include <algorithm>
#include <numbers>

namespace process {

namespace {

constexpr std::size_t mostSamples = 20000; ///< a quantile of 1 % needs no more
constexpr float pi = std::numbers::pi_v<float>;
constexpr float closedGap = pi / 2; ///< a neighbourhood with no larger gap is closed
/// A sample of a rim looks into nearly half a plane of nothing, and o is 0.15 h on the last row of a straight one
/// (alg. 6). What noise, tips and sharp edges make is rarely both.
constexpr float rimGap = 5 * pi / 6, rimOffCentre = 0.12f;
/// On coarse and narrow strips the last row lies a little farther inside; a rim must then be long to be believed.
constexpr float coarseOffCentre = 0.1f;
/// Rims shorter than this part of sqrt(n) spacings, some 1/12 of a half-sphere's, count as chance; measured on closed
/// scans (0 to 0.17) and on open ones (from 0.24, the small holes under the Stanford bunny).
constexpr double shortestRim = 0.2, longRim = 1;
constexpr float bandLimit = 0.3f; ///< for bands so narrow that all their samples see a rim (alg. 6.2)

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
    const bool oriented = tree.layout()->oriented;
    angles.clear();
    tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
        for (int slot = begin; slot < end; ++slot) {
            const base::Vec3f q = block.position(slot) - x;
            const float a = base::dot(q, u), b = base::dot(q, v), reach = block.support(slot);
            const float agrees = base::dot(block.normal(slot), normal);
            if (base::lengthSq(q) < reach * reach && a * a + b * b > 1e-6f * reach * reach &&
                (oriented ? agrees : std::abs(agrees)) > 0.5f)
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
};

std::vector<Sample> look(const surface::Surface& surface, std::span<const base::Vec3f> x,
                         const base::Progress& progress) {
    surface::ProjectOptions options;
    options.projector = surface::Projector::Basic;
    options.tolerance = 1e-4;
    options.checkBoundary = false;
    constexpr std::size_t slab = 2048;
    std::vector<Sample> out(x.size(), {0, std::numeric_limits<float>::quiet_NaN()}); // neither open nor closed
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
                                     angularGap(surface.tree(), x[from + i], feet[i].at.normal, angles)};
        });
    }
    return out;
}

bool hasRim(std::span<const Sample> samples, std::size_t surfels) {
    const auto open = [&](float offCentre) {
        return static_cast<double>(std::count_if(samples.begin(), samples.end(), [&](const Sample& s) {
            return s.gap >= rimGap && s.offCentre > offCentre;
        }));
    };
    const double expected = static_cast<double>(samples.size()) / std::sqrt(static_cast<double>(surfels));
    return open(rimOffCentre) >= std::max(3.0, shortestRim * expected) ||
           open(coarseOffCentre) >= std::max(8.0, longRim * expected);
}

} // namespace

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress) {
    const std::vector<base::Vec3f> x = samplePositions(surface.tree());
    const std::vector<Sample> samples = look(surface, x, progress);

    std::vector<float> closed;
    for (const Sample& s : samples)
        if (s.gap < closedGap)
            closed.push_back(s.offCentre);
    if (!hasRim(samples, surface.tree().size()))
        return std::numeric_limits<float>::infinity();
    if (closed.empty())
        return bandLimit;
    const auto quantile = closed.begin() + static_cast<std::ptrdiff_t>((closed.size() - 1) * 99 / 100);
    std::nth_element(closed.begin(), quantile, closed.end());
    return std::clamp(1.3f * *quantile, 0.15f, 0.45f);
}

} // namespace process
