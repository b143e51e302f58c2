#include "core/process/boundary_limit.h"

#include "core/base/parallel.h"
#include "core/surface/project.h"

#include <algorithm>
#include <numbers>

namespace process {

namespace {

constexpr std::size_t mostSamples = 20000; ///< a quantile of 1 % needs no more
constexpr float openGap = std::numbers::pi_v<float> / 2;
/// Fewer open neighbourhoods than this are chance: the emptiest of many noisy ones.
constexpr std::size_t fewestOpen = 4;

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
    angles.clear();
    tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
        for (int slot = begin; slot < end; ++slot) {
            const base::Vec3f q = block.position(slot) - x;
            const float a = base::dot(q, u), b = base::dot(q, v), reach = block.support(slot);
            if (base::lengthSq(q) < reach * reach && a * a + b * b > 1e-6f * reach * reach &&
                base::dot(block.normal(slot), normal) > 0.5f)
                angles.push_back(std::atan2(b, a));
        }
    });
    if (angles.empty())
        return 2 * std::numbers::pi_v<float>;
    std::sort(angles.begin(), angles.end());
    float gap = angles.front() + 2 * std::numbers::pi_v<float> - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i)
        gap = std::max(gap, angles[i] - angles[i - 1]);
    return gap;
}

} // namespace

float automaticBoundaryLimit(const surface::Surface& surface, const base::Progress& progress) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    progress.step(0, "Looking for boundaries");
    const std::vector<base::Vec3f> x = samplePositions(surface.tree());
    std::vector<surface::Projection<float>> feet(x.size());
    surface::ProjectOptions options;
    options.projector = surface::Projector::Basic;
    options.tolerance = 1e-4;
    options.checkBoundary = false;
    surface::project(surface, x, options, feet);

    progress.step(0.5, "Looking for boundaries");
    std::vector<float> offCentre(x.size()); // in units of h where closed, negative where open, NaN where undefined
    base::parallelChunks(x.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<float> angles;
        for (std::size_t i = begin; i < end; ++i) {
            const surface::Evaluationf& e = feet[i].at;
            if (!feet[i].ok())
                offCentre[i] = std::numeric_limits<float>::quiet_NaN();
            else if (angularGap(surface.tree(), x[i], e.normal, angles) >= openGap)
                offCentre[i] = -1;
            else
                offCentre[i] = e.offCentre / e.unit;
        }
    });
    std::erase_if(offCentre, [](float o) { return std::isnan(o); });
    const auto closed = std::partition(offCentre.begin(), offCentre.end(), [](float o) { return o < 0; });
    const std::size_t open = static_cast<std::size_t>(closed - offCentre.begin());
    if (open < fewestOpen || closed == offCentre.end())
        return infinity;
    const auto quantile = closed + (offCentre.end() - closed - 1) * 99 / 100;
    std::nth_element(closed, quantile, offCentre.end());
    return std::clamp(1.3f * *quantile, 0.15f, 0.45f);
}

} // namespace process
