#include "core/process/measuring/deviation.h"

#include "core/base/parallel.h"
#include "core/surface/curves/boundary.h"
#include "core/surface/projection/project.h"

#include <algorithm>

namespace process {

using base::Vec3d;
using surface::Status;

namespace {

/// What became of one surfel.
struct Foot {
    Status status = Status::NotConverged;
    double distance = 0;
};

/// Whether the surface ends where it is nearest to x: what lies so far out that there is no foot at all is beyond it.
bool isBeyond(const surface::Surface& to, const Vec3d& x) {
    std::vector<tree::Neighbour> nearest;
    to.tree().nearest(base::cast<float>(x), 1, nearest);
    if (nearest.empty() || !std::isfinite(to.definition().boundaryLimit))
        return false;
    const Vec3d last = base::cast<double>(nearest.front().block->position(nearest.front().slot));
    const surface::BoundarySearch rim =
        surface::findBoundaryPoint(to, last, {nearest.front().block->normal(nearest.front().slot)});
    return rim.ok() && base::distance(rim.point.position, last) < rim.point.unit;
}

/// A foot much farther than the nearest surfel is another place's: the iteration went astray.
bool isNear(const surface::Surface& to, const Vec3d& x, double distance, double unit) {
    std::vector<tree::Neighbour> nearest;
    to.tree().nearest(base::cast<float>(x), 1, nearest);
    return !nearest.empty() && distance <= std::sqrt(static_cast<double>(nearest.front().distanceSq)) + unit;
}

Foot footOf(const surface::Surface& to, const Vec3d& x, bool sided) {
    Foot out;
    for (const surface::Projector projector : {surface::Projector::Orthogonal, surface::Projector::Almost}) {
        surface::ProjectOptions options;
        options.projector = projector;
        const surface::Projection<double> found = surface::projectReference(to, x, options);
        out.status = found.status;
        if (found.status != Status::Ok && found.status != Status::BeyondBoundary)
            continue;
        const Vec3d away = x - found.foot;
        out.distance = length(away);
        if (!isNear(to, x, out.distance, found.at.unit)) {
            out.status = Status::NotConverged;
            continue;
        }
        if (sided && dot(away, found.at.gradient) < 0)
            out.distance = -out.distance;
        return out;
    }
    if (isBeyond(to, x))
        out.status = Status::BeyondBoundary;
    return out;
}

} // namespace

static DeviationFigures figuresOf(const std::vector<Foot>& feet, bool sided) {
    DeviationFigures out;
    out.sided = sided;
    std::vector<double> sizes;
    double sum = 0, squares = 0;
    for (const Foot& foot : feet) {
        out.beyond += foot.status == Status::BeyondBoundary;
        out.lost += foot.status != Status::Ok && foot.status != Status::BeyondBoundary;
        if (foot.status != Status::Ok)
            continue;
        sum += foot.distance, squares += foot.distance * foot.distance;
        sizes.push_back(std::abs(foot.distance));
    }
    out.count = sizes.size();
    if (sizes.empty())
        return out;
    std::sort(sizes.begin(), sizes.end());
    const auto n = static_cast<double>(sizes.size());
    out.rms = std::sqrt(squares / n), out.mean = sum / n;
    out.max = sizes.back(), out.p99 = sizes[sizes.size() - 1 - sizes.size() / 100];
    return out;
}

Deviations deviationsOf(const tree::SurfelTree& from, const surface::Surface& to, const Vec3d& shift,
                        const base::Progress& progress) {
    constexpr std::size_t slab = 4096;
    const bool sided = to.tree().layout()->normals && to.tree().layout()->oriented;
    const surfel::SurfelList points = from.surfels();
    std::vector<Foot> feet(points.size());
    for (std::size_t first = 0; first < feet.size(); first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(feet.size()), "Measuring distances");
        base::parallelFor(std::min(slab, feet.size() - first), 32, [&](std::size_t i) {
            feet[first + i] = footOf(to, base::cast<double>(points.items[first + i].position) + shift, sided);
        });
    }
    Deviations out;
    out.figures = figuresOf(feet, sided);
    for (const Foot& foot : feet) {
        out.distance.push_back(foot.status == Status::Ok ? foot.distance : std::numeric_limits<double>::quiet_NaN());
        out.status.push_back(foot.status);
    }
    return out;
}

} // namespace process
