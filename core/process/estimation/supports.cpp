#include "core/process/estimation/supports.h"

#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/cloud_supports.h"
#include "core/process/estimation/neighbour_graph.h"
#include "core/process/estimation/outliers.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

namespace {

constexpr std::size_t ringSize = 6; ///< that spacing is made of
/// Of radii over distance (process/README 1.3).
constexpr float steepest = 0.5f;
/// A position that stands this many times sparser than the median of its neighbours is an outlier and gets no more.
constexpr float sparsest = 3.0f;

std::vector<float> spacingsOf(const NeighbourGraph& g, std::size_t n) {
    std::vector<float> out(n);
    const std::size_t k = std::min<std::size_t>(ringSize, g.count);
    base::parallelFor(n, 8192, [&](std::size_t i) {
        double sum = 0;
        for (std::size_t j = 0; j < k; ++j)
            sum += static_cast<double>(g.distance[i * g.count + j]);
        out[i] = static_cast<float>(spacingOverDistance * sum / static_cast<double>(k));
    });
    return out;
}

/// An outlier's reach would otherwise follow its distance from everything, and grading would carry that into the model.
std::vector<float> withoutOutliers(const std::vector<float>& spacing, const NeighbourGraph& g) {
    std::vector<float> out(spacing.size());
    base::parallelFor(spacing.size(), 4096, [&](std::size_t i) {
        float near[gradedNeighbours];
        for (std::size_t k = 0; k < g.count; ++k)
            near[k] = spacing[g.index[i * g.count + k]];
        std::nth_element(near, near + g.count / 2, near + g.count);
        out[i] = std::min(spacing[i], sparsest * near[g.count / 2]);
    });
    return out;
}

/// Raises what lies more than a slope below a neighbour until nothing does: the largest of all h_j - slope d_ij. That
/// fixed point is unique, so that the order of the sweeps cannot show. Along a Morton curve two or three suffice.
void raise(std::vector<float>& h, const NeighbourGraph& g, const base::Progress& progress) {
    const auto relax = [&](std::size_t i) {
        bool changed = false;
        for (std::size_t e = i * g.count; e < (i + 1) * g.count; ++e) {
            float &a = h[i], &b = h[g.index[e]];
            const float drop = steepest * g.distance[e];
            if (a < b - drop)
                a = b - drop, changed = true;
            else if (b < a - drop)
                b = a - drop, changed = true;
        }
        return changed;
    };
    const std::size_t n = h.size();
    bool changed = true;
    for (int sweep = 0; changed; ++sweep) {
        changed = false;
        const double done = 1 - 1 / (1 + 0.2 * sweep); // nobody knows how many there will be
        for (std::size_t i = 0; i < n; ++i) {
            if (i % 65536 == 0)
                progress.step(done, "Grading supports");
            changed |= relax(sweep % 2 ? n - 1 - i : i);
        }
    }
}

/// What grading has made this many times as wide as its own place asks for, and so wide that it holds too many
/// positions, gets few of them; counted by every 64th.
constexpr float farRaised = 3.0f;
constexpr std::size_t countedEach = 64, tooMany = 64, few = 4;

/// A pile of points in a sparse surrounding would be raised until each of them holds all the others. `own`: what every
/// place asks for by itself.
void sparePiles(std::vector<float>& h, const std::vector<float>& own, std::span<const base::Vec3f> positions,
                const base::Progress& progress) {
    const auto isRaised = [&](std::size_t i) { return h[i] > farRaised * own[i]; };
    bool any = false;
    for (std::size_t i = 0; i < h.size() && !any; ++i)
        any = isRaised(i);
    if (!any || positions.size() < countedEach * tooMany)
        return;
    std::vector<surfel::Surfel> some; // along the Morton curve, hence evenly
    for (std::size_t i = 0; i < positions.size(); i += countedEach)
        some.emplace_back().position = positions[i];
    const Cloud counted(some, progress);
    base::parallelFor(h.size(), 1024, [&](std::size_t i) {
        if (isRaised(i) && h[i] > counted.reach(positions[i], tooMany))
            h[i] = std::max(own[i], counted.reach(positions[i], few));
    });
}

/// The mean of the smallest graded field above `h` and the largest below it: of all graded fields the one that departs
/// least from `h` (McShane and Whitney's extensions), unbiased where spacing is only noisy, and nowhere under half of
/// `h`, so that no place loses its cover.
void grade(std::vector<float>& h, const NeighbourGraph& g, const base::Progress& progress) {
    std::vector<float> above = h, below(h.size());
    std::transform(h.begin(), h.end(), below.begin(), std::negate<>());
    raise(above, g, part(progress, 0, 0.5));
    raise(below, g, part(progress, 0.5, 1));
    for (std::size_t i = 0; i < h.size(); ++i)
        h[i] = 0.5f * (above[i] - below[i]);
}

} // namespace

std::vector<float> supportsOf(const Cloud& cloud, const surfel::SurfelList& points,
                              const surface::SurfaceDefinition& definition, const base::Progress& progress) {
    const bool gaussian = definition.weight == surface::Weight::Gaussian;
    const float reach = gaussian ? surface::gaussianReach : 1.0f;
    if (definition.support > 0)
        return std::vector<float>(cloud.size(), definition.support * reach);
    if (cloud.size() < 2)
        return std::vector<float>(cloud.size(), 1.0f); // a lone point has no scale; any will do
    NeighbourGraph graph = neighbourGraph(cloud, points, part(progress, 0, 0.7));
    std::vector<float> own = spacingsOf(graph, cloud.size());
    std::vector<float> h = withoutOutliers(own, graph);
    const float perSpacing = definition.unitInSpacings();
    for (auto* each : {&own, &h})
        for (float& value : *each)
            value = std::max(value * perSpacing, 1e-18f); // denormal distances
    const Outliers outliers = cutOutliers(graph, cloud.positions(), h);
    grade(h, graph, part(progress, 0.7, 1));
    if (!outliers.members.empty()) {
        lowerOutliers(h, graph, outliers, steepest);
        raise(h, graph, progress); // what they see was graded without them
    }
    sparePiles(h, own, cloud.positions(), progress);
    if (gaussian)
        for (float& value : h)
            value *= surface::gaussianScale * reach;
    return h;
}

void assignSupports(surfel::SurfelList& points, const surface::SurfaceDefinition& definition,
                    const base::Progress& progress) {
    if (points.items.empty())
        return;
    const Cloud cloud(points.items, part(progress, 0, 0.3));
    const std::vector<float> h = supportsOf(cloud, points, definition, part(progress, 0.3, 1));
    for (std::size_t i = 0; i < points.size(); ++i)
        points.items[i].support = h[cloud.places()[i]];
}

} // namespace process
