#include "core/process/estimation/rim_samples.h"

#include "core/base/parallel.h"
#include "core/process/estimation/widest_gap.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace process {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Who may lie at a rim: a sample of one looks into nearly half a plane of nothing. On the last row of a straight rim o
/// is 0.13 h (process/README 3), on a narrow strip 0.1 h, and half of that where samples lie along the rim twice as
/// densely as they do across it.
constexpr float rimGap = 2 * pi / 3, rimOffCentre = 0.08f, sidedOffCentre = 0.04f;
/// Who does: beyond a rim o grows to any limit within 0.3 h, while noise, tips and sharp edges have their maximum.
constexpr double rimReach = 0.8;

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
    return widestGap(angles);
}

} // namespace

std::vector<RimSample> lookAt(const surface::Surface& surface, std::span<const RimPlace> places,
                              const base::Progress& progress) {
    std::vector<base::Vec3f> x(places.size());
    std::transform(places.begin(), places.end(), x.begin(), [](const RimPlace& each) { return each.position; });
    surface::ProjectOptions options;
    options.projector = surface::Projector::Basic;
    options.tolerance = 1e-4;
    options.checkBoundary = false;
    constexpr std::size_t slab = 2048;
    std::vector<RimSample> out(x.size());
    std::vector<surface::Projection<float>> feet(slab);
    for (std::size_t from = 0; from < x.size(); from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(x.size()), "Looking for boundaries");
        const std::size_t n = std::min(slab, x.size() - from);
        surface::project(surface, std::span(x).subspan(from, n), options, std::span(feet).first(n));
        base::parallelChunks(n, 128, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<float> angles;
            for (std::size_t i = begin; i < end; ++i) {
                out[from + i].at = places[from + i];
                if (feet[i].ok())
                    out[from + i] = {places[from + i], feet[i].at.offCentre / feet[i].at.unit,
                                     angularGap(surface.tree(), x[from + i], feet[i].at.normal, angles), feet[i].foot,
                                     feet[i].at.normal};
            }
        });
    }
    return out;
}

surface::Surface loosened(const surface::Surface& surface) {
    surface::SurfaceDefinition definition = surface.definition();
    definition.boundaryLimit = loosestLimit;
    return {surface.tree(), definition};
}

surface::BoundarySearch rimBeside(const surface::Surface& loose, const RimSample& sample) {
    const float least = loose.tree().layout()->oriented ? sidedOffCentre : rimOffCentre;
    if (!(sample.gap >= rimGap && sample.offCentre > least))
        return {surface::Status::NotConverged, {}, 0};
    const base::Vec3d foot = base::cast<double>(sample.foot);
    surface::BoundarySearch out = surface::findBoundaryPoint(loose, foot);
    if (out.ok() && distance(out.point.position, foot) >= rimReach * out.point.unit)
        out.status = surface::Status::NotConverged;
    return out;
}

} // namespace process
