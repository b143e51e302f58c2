#include "core/process/cleaning/find_outliers.h"

#include "core/base/disjoint_sets.h"
#include "core/base/ranked.h"
#include "core/process/cleaning/local_quadric.h"
#include "core/process/cleaning/mutual_spacing.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/outliers.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace process {

namespace {

constexpr std::size_t looked = 16, grain = 2048;
using Flags = std::vector<std::uint8_t>;

/// body(i, others): `others` are places in the row of i that it is compared with, the mutual neighbours, or all where
/// there are none.
template <class Body>
void forCompared(const NearestGraph& graph, const Body& body) {
    base::parallelChunks(graph.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<std::uint32_t> others;
        for (std::size_t i = begin; i < end; ++i) {
            mutualNeighbours(graph, i, others);
            if (others.empty())
                for (std::uint32_t k = 0; k < graph.count; ++k)
                    others.push_back(k);
            body(i, others);
        }
    });
}

/// Mean distances vary by a seventh in random samplings, by up to a half about corners of open sheets.
Flags byDistance(const Cloud& cloud, double limit, const base::Progress& progress) {
    const double least = std::log(2.0);
    const NearestGraph graph = nearestGraph(cloud, looked, progress);
    std::vector<double> level(cloud.size());
    base::parallelFor(cloud.size(), grain, [&](std::size_t i) {
        double sum = 0;
        for (std::size_t k = 0; k < graph.count; ++k)
            sum += static_cast<double>(graph.distance[i * graph.count + k]);
        level[i] = std::log(std::max(sum, 1e-300));
    });
    Flags out(cloud.size());
    forCompared(graph, [&](std::size_t i, const std::vector<std::uint32_t>& others) {
        std::vector<double> levels;
        for (const std::uint32_t k : others)
            levels.push_back(level[graph.index[i * graph.count + k]]);
        const Spread usual = spreadOf(levels);
        out[i] = level[i] - usual.median > std::max(least, limit * usual.deviation);
    });
    return out;
}

Flags byCount(const Cloud& cloud, double limit, const base::Progress& progress) {
    constexpr float reach = 3; ///< of local spacings: 36 others in a hexagonal layout, 12 in its sharpest corner
    const NearestGraph graph = nearestGraph(cloud, looked, progress);
    const std::vector<float> own = mutualSpacings(graph);
    Flags out(cloud.size());
    forCompared(graph, [&](std::size_t i, const std::vector<std::uint32_t>& others) {
        std::vector<double> spacings;
        for (const std::uint32_t k : others)
            spacings.push_back(static_cast<double>(own[graph.index[i * graph.count + k]]));
        const float radius = reach * static_cast<float>(spreadOf(spacings).median);
        std::size_t count = 0;
        while (count < graph.count && graph.distance[i * graph.count + count] <= radius)
            ++count;
        out[i] = static_cast<double>(count) < limit && count < graph.count;
    });
    return out;
}

/// Neighbours are connected where no more than two of the larger own spacing of both lie between them: a sparse part
/// with the dense one beside it, but a stray, which has no mutual neighbours, with nothing that is far.
Flags byPieces(const Cloud& cloud, const std::optional<double>& limit, const base::Progress& progress) {
    constexpr float reach = 2;
    const NearestGraph graph = nearestGraph(cloud, gradedNeighbours, progress);
    const std::vector<float> own = mutualSpacings(graph);
    base::DisjointSets pieces(cloud.size());
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
        if (i % 65536 == 0)
            progress.step(1, "Looking for islands");
        for (std::size_t e = i * graph.count; e < (i + 1) * graph.count; ++e)
            if (const std::uint32_t j = graph.index[e]; graph.distance[e] <= reach * std::max(own[i], own[j]))
                pieces.join(i, j);
    }
    std::vector<std::size_t> size(cloud.size());
    for (std::uint32_t i = 0; i < cloud.size(); ++i)
        ++size[pieces.find(i)];
    const auto largest = static_cast<double>(*std::max_element(size.begin(), size.end()));
    const double least = limit.value_or(std::sqrt(largest));
    Flags out(cloud.size());
    for (std::uint32_t i = 0; i < cloud.size(); ++i)
        out[i] = static_cast<double>(size[pieces.find(i)]) < std::min(least, largest);
    return out;
}

/// How far position i stands off the quadric through its neighbours without it, which robust weights keep from other
/// strays. Not finite where there is no telling.
double residualWithout(std::span<const base::Vec3f> positions, std::size_t i, const Neighbours& near) {
    constexpr int rounds = 4;
    constexpr double leastReach = 0.01; ///< of the neighbourhood: what no sampling is better than
    const LocalFrame frame = planeFrame(positions, i, near.index, {});
    const double radius = std::sqrt(static_cast<double>(near.distanceSq.back()));
    std::vector<base::Vec3d> local;
    std::vector<double> residuals;
    for (const std::uint32_t j : near.index) {
        const base::Vec3d q = base::cast<double>(positions[j]) - frame.origin;
        local.push_back({dot(q, frame.u), dot(q, frame.v), dot(q, frame.n)});
        residuals.push_back(local.back().z);
    }
    const double middle = spreadOf(residuals).median;
    for (double& r : residuals)
        r -= middle;
    QuadricFit fit;
    for (int round = 0; round < rounds; ++round) {
        const double reach = std::max(robustReach * spreadOf(residuals).deviation, leastReach * radius);
        QuadricSums sums(radius);
        for (std::size_t k = 0; k < local.size(); ++k)
            if (const double weight = biweight(residuals[k], reach); weight > 0)
                sums.add(local[k].x, local[k].y, local[k].z, weight);
        fit = sums.fit();
        for (std::size_t k = 0; k < local.size(); ++k)
            residuals[k] = local[k].z - fit.at(local[k].x, local[k].y);
    }
    return fit.distance();
}

/// Mean squared sine between the ways from a position to its neighbours and their tangent planes: next to nothing on a
/// surface, a third in a swarm that fills space.
double steepness(const Cloud& cloud, const Neighbours& near, std::span<const base::Vec3f> normals, std::size_t i) {
    double sum = 0;
    for (const std::uint32_t j : near.index) {
        const base::Vec3f way = base::normalized(cloud.positions()[j] - cloud.positions()[i]);
        const double rise = static_cast<double>(dot(way, normals[j]));
        sum += rise * rise;
    }
    return sum / static_cast<double>(near.size());
}

/// The mean steepness of a group as if it stood alone.
double steepnessAlone(const Cloud& cloud, std::span<const std::uint32_t> group, const base::Progress& quiet) {
    std::vector<surfel::Surfel> points(group.size());
    for (std::size_t m = 0; m < group.size(); ++m)
        points[m].position = cloud.positions()[group[m]];
    const Cloud alone(points, quiet);
    const std::vector<base::Vec3f> normals = normalsOf(alone, 18, quiet);
    std::vector<double> steep(alone.size());
    alone.forEach(gradedNeighbours, quiet, "Looking for swarms",
                  [&](std::size_t i, const Neighbours& near) { steep[i] = steepness(alone, near, normals, i); });
    return std::accumulate(steep.begin(), steep.end(), 0.0) / static_cast<double>(steep.size());
}

/// Swarms about the model: few sparse points that see it and that nothing of it sees, above it and not beside it, and
/// that are no surface themselves.
void addSwarms(const Cloud& cloud, Flags& found, const base::Progress& progress) {
    constexpr double fillsSpace = 0.17;
    /// Of a large group's mean: samples of a surface by chance, with noise of half their spacing, have 0.18, clouds of
    /// strays 0.22 to 0.24.
    constexpr double largeFillsSpace = 0.2;
    constexpr SwarmLimit limit{1 / 3.0, std::numeric_limits<std::size_t>::max()};
    NeighbourGraph graph(nearestTable(cloud, gradedNeighbours, part(progress, 0, 0.3)), cloud.positions());
    const std::vector<float> spacing = spacingsOf(cloud, part(progress, 0.3, 0.5));
    const Outliers swarms = cutOutliers(graph, spacing, limit);
    const std::vector<std::uint32_t>& members = swarms.members;
    if (members.empty())
        return;
    const std::vector<base::Vec3f> normals = normalsOf(cloud, 18, part(progress, 0.5, 1));
    std::vector<Neighbours> near(members.size()); // the graph has forgotten what lies beside the model
    std::vector<double> steep(cloud.size(), -1);
    base::parallelFor(members.size(), 256, [&](std::size_t m) {
        cloud.nearest(members[m], gradedNeighbours, near[m]);
        steep[members[m]] = steepness(cloud, near[m], normals, members[m]);
    });
    std::size_t from = 0;
    for (const std::size_t end : swarms.ends) {
        const std::span<const std::uint32_t> group(members.data() + from, end - from);
        const bool large = group.size() > SwarmLimit().of(cloud.size());
        const bool judged = !large || steepnessAlone(cloud, group, {nullptr, progress.cancel}) > largeFillsSpace;
        for (std::size_t m = from; m < end && judged; ++m) {
            double sum = steep[members[m]], count = 1; // few directions tell little: those beside it count too
            for (const std::uint32_t j : near[m].index)
                if (const double beside = steep[j]; beside >= 0)
                    sum += beside, ++count;
            found[members[m]] |= sum > fillsSpace * count;
        }
        from = end;
    }
}

Flags bySurface(const Cloud& cloud, double limit, const base::Progress& progress) {
    constexpr std::size_t fitted = 30;
    constexpr double least = 0.25; ///< of the local spacing: nearer than this nothing is off the surface
    std::vector<double> residual(cloud.size());
    cloud.forEach(
        fitted, part(progress, 0, 0.7), "Comparing with the surface",
        [&](std::size_t i, const Neighbours& near) { residual[i] = residualWithout(cloud.positions(), i, near); });
    const NearestGraph graph = nearestGraph(cloud, looked, part(progress, 0.7, 1));
    const std::vector<float> own = mutualSpacings(graph);
    Flags out(cloud.size());
    forCompared(graph, [&](std::size_t i, const std::vector<std::uint32_t>& others) {
        std::vector<double> sizes, spacings;
        for (std::size_t e = i * graph.count; e < (i + 1) * graph.count; ++e)
            sizes.push_back(std::abs(residual[graph.index[e]]));
        for (const std::uint32_t k : others)
            spacings.push_back(static_cast<double>(own[graph.index[i * graph.count + k]]));
        const double noise = deviationOverMad * base::median(sizes);
        out[i] = std::abs(residual[i]) > std::max(limit * noise, least * base::median(spacings));
    });
    return out;
}

} // namespace

static Flags byItsOwnWay(const Cloud& cloud, const OutlierQuestion& question, const base::Progress& progress) {
    constexpr double deviations = 4, others = 6;
    switch (question.way) {
    case OutlierWay::Statistical:
        return byDistance(cloud, question.limit.value_or(deviations), progress);
    case OutlierWay::Radius:
        return byCount(cloud, question.limit.value_or(others), progress);
    case OutlierWay::Islands:
        return byPieces(cloud, question.limit, progress);
    default:
        return bySurface(cloud, question.limit.value_or(deviations), progress);
    }
}

std::vector<std::uint8_t> findOutliers(const Cloud& cloud, const OutlierQuestion& question,
                                       const base::Progress& progress) {
    if (cloud.size() <= looked)
        return Flags(cloud.size()); // too few to tell what is usual
    Flags out = byItsOwnWay(cloud, question, part(progress, 0, 0.7));
    addSwarms(cloud, out, part(progress, 0.7, 1));
    return out;
}

} // namespace process
