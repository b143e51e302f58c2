// Consistent orientation: the minimum spanning tree of unlikeness over the neighbour graph [Hoppe92],
// with a flip rule (process/README 2.2) that knows the edge between the two points.
#include "core/base/disjoint_sets.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/outside.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

namespace {

/// Edges in classes of likeness: as fine as float normals of a scan mean anything, and sorted in one pass.
constexpr std::size_t classes = 1 << 14;

constexpr const char* orienting = "Orienting normals";

struct Edge {
    std::uint32_t a, b;
};

struct Likeness {
    bool flip;
    std::uint16_t unlike; ///< 0 certain to classes - 1
};

/// Compares the normal at b with the one that a circular arc from a to b would carry there, the normal at a mirrored in
/// the plane halfway: exact on spheres and cylinders, and right across sharp edges, where n_a . n_b is 0. An edge along
/// the normals joins two layers or two sides of something thin, and nobody can tell which: it comes last.
Likeness likeness(const base::Vec3f& a, const base::Vec3f& na, const base::Vec3f& b, const base::Vec3f& nb) {
    const base::Vec3f e = base::normalized(b - a);
    const float alongA = base::dot(na, e), alongB = base::dot(nb, e);
    const float arc = base::dot(na, nb) - 2 * alongA * alongB;
    const float steep = std::max(alongA * alongA, alongB * alongB);
    const float unlike = std::clamp(1 - std::abs(arc) * (1 - steep), 0.0f, 1.0f);
    return {arc < 0, static_cast<std::uint16_t>(unlike * (classes - 1))};
}

/// Every pair of neighbours once, from the one that comes first or the only one that names the other.
std::vector<Edge> neighbourPairs(const Cloud& cloud, std::size_t k, const base::Progress& progress) {
    k = std::min(k, cloud.size() - 1);
    std::vector<std::uint32_t> near(cloud.size() * k);
    cloud.forEach(k, progress, "Linking neighbours", [&](std::size_t i, const Neighbours& found) {
        std::copy(found.index.begin(), found.index.end(), near.begin() + static_cast<std::ptrdiff_t>(i * k));
    });
    const auto names = [&](std::size_t i, std::uint32_t j) {
        const auto begin = near.begin() + static_cast<std::ptrdiff_t>(i * k);
        return std::find(begin, begin + static_cast<std::ptrdiff_t>(k), j) != begin + static_cast<std::ptrdiff_t>(k);
    };
    constexpr std::size_t grain = 8192;
    std::vector<std::vector<Edge>> parts(base::chunkCount(cloud.size(), grain));
    base::parallelChunks(cloud.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t e = i * k; e < (i + 1) * k; ++e)
                if (near[e] > i || !names(near[e], static_cast<std::uint32_t>(i)))
                    parts[chunk].push_back({static_cast<std::uint32_t>(i), near[e]});
    });
    std::vector<Edge> out;
    for (const auto& p : parts)
        out.insert(out.end(), p.begin(), p.end());
    return out;
}

/// Stable: ties keep the order of the points along the curve.
std::vector<std::uint32_t> byUnlikeness(const std::vector<Likeness>& likenesses) {
    std::vector<std::uint32_t> start(classes + 1), order(likenesses.size());
    for (const Likeness& l : likenesses)
        ++start[l.unlike + 1u];
    for (std::size_t c = 0; c < classes; ++c)
        start[c + 1] += start[c];
    for (std::uint32_t e = 0; e < order.size(); ++e)
        order[start[likenesses[e].unlike]++] = e;
    return order;
}

/// Edges this unlike or less are certain: on two-sided scans, raw ones included, next to none of them contradicts the
/// others (at most 0.07 sqrt(n) points, found on 30 models), while a Moebius strip's seam of them cannot vanish.
constexpr std::size_t certain = classes / 20;
constexpr double seamLength = 0.3; ///< in sqrt(n) points, from which there is a seam
constexpr std::size_t leastSeam = 4;

/// Is there a seam, along which certain edges contradict the signs that the trees gave?
bool hasSeam(base::ParitySets& trees, const std::vector<Edge>& edges, const std::vector<Likeness>& likenesses,
             std::size_t points) {
    std::vector<std::uint32_t> seam;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (likenesses[e].unlike >= certain)
            continue;
        const auto a = trees.find(edges[e].a), b = trees.find(edges[e].b);
        if (a.root == b.root && (a.opposite != b.opposite) != likenesses[e].flip)
            seam.insert(seam.end(), {edges[e].a, edges[e].b});
    }
    std::sort(seam.begin(), seam.end());
    const auto length = static_cast<std::size_t>(std::unique(seam.begin(), seam.end()) - seam.begin());
    return length >= leastSeam && static_cast<double>(length) >= seamLength * std::sqrt(static_cast<double>(points));
}

struct Orientation {
    base::ParitySets trees; ///< with the flips along their edges
    bool sided;             ///< the signs agree everywhere
};

/// Kruskal's minimum spanning trees of the neighbour graph.
Orientation spanningTrees(const Cloud& cloud, std::span<const base::Vec3f> normals, int neighbours,
                          const base::Progress& progress) {
    const std::vector<Edge> edges = neighbourPairs(cloud, static_cast<std::size_t>(neighbours), part(progress, 0, 0.6));
    progress.step(0.6, orienting);
    std::vector<Likeness> likenesses(edges.size());
    base::parallelFor(edges.size(), 16384, [&](std::size_t e) {
        const auto [a, b] = edges[e];
        likenesses[e] = likeness(cloud.positions()[a], normals[a], cloud.positions()[b], normals[b]);
    });
    progress.step(0.65, orienting);
    const std::vector<std::uint32_t> order = byUnlikeness(likenesses);
    base::ParitySets trees(cloud.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k % 131072 == 0)
            progress.step(0.7 + 0.2 * static_cast<double>(k) / static_cast<double>(order.size()), orienting);
        const std::uint32_t e = order[k];
        trees.relate(edges[e].a, edges[e].b, likenesses[e].flip);
    }
    const bool sided = !hasSeam(trees, edges, likenesses, cloud.size());
    return {std::move(trees), sided};
}

} // namespace

bool orient(const Cloud& cloud, std::span<base::Vec3f> normals, int neighbours, const base::Progress& progress) {
    const std::size_t n = cloud.size();
    if (n < 2)
        return true;
    auto [trees, sided] = spanningTrees(cloud, normals, neighbours, progress);
    std::vector<std::uint32_t> start(n + 1), members(n), rootOf(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto [root, flip] = trees.find(i);
        if (flip)
            normals[i] = -normals[i];
        rootOf[i] = root;
        ++start[root + 1];
    }
    for (std::size_t i = 0; i < n; ++i)
        start[i + 1] += start[i];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i)
        members[next[rootOf[i]]++] = i;
    const Outside outside(cloud.positions());
    for (std::size_t root = 0; root < n; ++root) {
        const std::span<const std::uint32_t> component(members.data() + start[root], start[root + 1] - start[root]);
        if (component.empty())
            continue;
        progress.step(0.9 + 0.1 * static_cast<double>(root) / static_cast<double>(n), orienting);
        if (outside.inward(normals, component))
            for (const std::uint32_t i : component)
                normals[i] = -normals[i];
    }
    return sided;
}

} // namespace process
