// Consistent orientation: the minimum spanning tree of unlikeness over the neighbour graph [Hoppe92],
// with a flip rule (process/README 2.2) that knows the edge between the two points.
#include "core/base/disjoint_sets.h"
#include "core/base/radix_sort.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/outside.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

namespace {

/// Edges in classes of likeness: as fine as float normals of a scan mean anything, and sorted in one pass.
constexpr std::size_t classes = 1 << 14;

constexpr const char* orienting = "Orienting normals";

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

/// Edges this unlike or less are certain: on two-sided scans, raw ones included, next to none of them contradicts the
/// others (at most 0.07 sqrt(n) points, found on 30 models), while a Moebius strip's seam of them cannot vanish.
constexpr std::size_t certain = classes / 20;
constexpr double seamLength = 0.3; ///< in sqrt(n) points, from which there is a seam
constexpr std::size_t leastSeam = 4;

struct Edge {
    std::uint32_t a, b;
    std::uint16_t unlike;
    bool flip;
};

/// Kruskal's minimum spanning trees of the neighbour graph, with the flips along their edges. Edges come by classes of
/// likeness, those of a class in the order of the points along the curve. They are not kept: a band of classes at a
/// time is taken from the graph, without what joins points that are joined already, which is nearly all of it soon.
class SpanningTrees {
  public:
    SpanningTrees(const Cloud& cloud, const NeighbourTable& links, std::span<const base::Vec3f> normals)
        : m_positions(cloud.positions()), m_links(links), m_normals(normals), m_trees(cloud.size()) {}

    void grow(const base::Progress& progress) {
        const std::vector<std::size_t> before = countsBelow(part(progress, 0, 0.2));
        std::size_t room = std::max<std::size_t>(m_links.size() / 4, 1), begin = 0;
        while (begin < classes) {
            // As many classes as make so many edges, at least one. The more points are joined, the fewer are left of
            // the edges that there are.
            std::size_t end = begin + 1;
            while (end < classes && before[end + 1] - before[begin] <= room)
                ++end;
            const double done = static_cast<double>(begin) / classes;
            join(begin, end, part(progress, 0.2 + 0.6 * done, 0.2 + 0.6 * static_cast<double>(end) / classes));
            begin = end;
            room *= 2;
        }
    }

    /// Is there a seam, along which certain edges contradict the signs that the trees gave?
    bool hasSeam(const base::Progress& progress) const {
        std::vector<std::vector<std::uint32_t>> parts(base::chunkCount(m_links.size(), grain));
        forSlabs(progress, [&](std::size_t i, std::size_t chunk) {
            const NeighbourTable::Row row = m_links.row(i);
            const auto a = m_trees.look(static_cast<std::uint32_t>(i));
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                const auto b = m_trees.look(row[k]);
                if (a.root != b.root)
                    continue;
                const Likeness along = likenessOf(i, row[k]);
                if (along.unlike < certain && (a.opposite != b.opposite) != along.flip)
                    parts[chunk].insert(parts[chunk].end(), {static_cast<std::uint32_t>(i), row[k]});
            }
        });
        std::vector<std::uint32_t> seam;
        for (const auto& each : parts)
            seam.insert(seam.end(), each.begin(), each.end());
        std::sort(seam.begin(), seam.end());
        const auto length = static_cast<std::size_t>(std::unique(seam.begin(), seam.end()) - seam.begin());
        const double least = seamLength * std::sqrt(static_cast<double>(m_links.size()));
        return length >= leastSeam && static_cast<double>(length) >= least;
    }

    base::ParitySets::Member look(std::uint32_t i) const { return m_trees.look(i); }

  private:
    static constexpr std::size_t grain = 8192, slab = 64 * grain;

    Likeness likenessOf(std::size_t i, std::size_t j) const {
        return likeness(m_positions[i], m_normals[i], m_positions[j], m_normals[j]);
    }

    /// body(i, chunk) for all points, in parallel.
    template <class Body>
    void forSlabs(const base::Progress& progress, const Body& body) const {
        const std::size_t n = m_links.size();
        for (std::size_t from = 0; from < n; from += slab) {
            progress.step(static_cast<double>(from) / static_cast<double>(n), orienting);
            base::parallelChunks(std::min(slab, n - from), grain,
                                 [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                     for (std::size_t i = from + begin; i < from + end; ++i)
                                         body(i, from / grain + chunk);
                                 });
        }
    }

    /// Number of edges in the classes below each.
    std::vector<std::size_t> countsBelow(const base::Progress& progress) const {
        std::vector<std::size_t> counts(classes + 1);
        std::vector<std::vector<std::uint16_t>> found(slab / grain);
        const std::size_t n = m_links.size(), k = m_links.count();
        for (std::size_t from = 0; from < n; from += slab) {
            progress.step(static_cast<double>(from) / static_cast<double>(n), orienting);
            const std::size_t size = std::min(slab, n - from);
            base::parallelChunks(size, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                found[chunk].clear();
                for (std::size_t i = from + begin; i < from + end; ++i) {
                    const NeighbourTable::Row row = m_links.row(i);
                    for (std::size_t e = 0; e < k; ++e)
                        found[chunk].push_back(likenessOf(i, row[e]).unlike);
                }
            });
            for (std::size_t chunk = 0; chunk < base::chunkCount(size, grain); ++chunk)
                for (const std::uint16_t unlike : found[chunk])
                    ++counts[unlike + 1u];
        }
        for (std::size_t c = 0; c < classes; ++c)
            counts[c + 1] += counts[c];
        return counts;
    }

    /// All edges of the classes that join something. That an edge may be found from both its ends does no harm: the
    /// second time it joins nothing.
    void join(std::size_t begin, std::size_t end, const base::Progress& progress) {
        std::vector<std::vector<Edge>> parts(base::chunkCount(m_links.size(), grain));
        forSlabs(part(progress, 0, 0.6), [&](std::size_t i, std::size_t chunk) {
            const NeighbourTable::Row row = m_links.row(i);
            const auto root = m_trees.look(static_cast<std::uint32_t>(i)).root;
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                if (m_trees.look(row[k]).root == root)
                    continue;
                const Likeness along = likenessOf(i, row[k]);
                if (along.unlike >= begin && along.unlike < end)
                    parts[chunk].push_back({static_cast<std::uint32_t>(i), row[k], along.unlike, along.flip});
            }
        });
        std::size_t count = 0;
        for (const auto& each : parts)
            count += each.size();
        std::vector<Edge> edges;
        edges.reserve(count);
        for (auto& each : parts) {
            edges.insert(edges.end(), each.begin(), each.end());
            std::vector<Edge>().swap(each);
        }
        base::radixSort(edges, 14, [](const Edge& edge) { return edge.unlike; });
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (e % 131072 == 0)
                progress.step(0.7 + 0.3 * static_cast<double>(e) / static_cast<double>(edges.size()), orienting);
            m_trees.relate(edges[e].a, edges[e].b, edges[e].flip);
        }
        base::parallelFor(m_links.size(), grain,
                          [&](std::size_t i) { m_trees.shorten(static_cast<std::uint32_t>(i)); });
    }

    std::span<const base::Vec3f> m_positions;
    const NeighbourTable& m_links;
    std::span<const base::Vec3f> m_normals;
    base::ParitySets m_trees;
};

} // namespace

bool orient(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
            const base::Progress& progress) {
    const std::size_t n = cloud.size();
    if (n < 2)
        return true;
    static_assert(classes == 1 << 14);
    SpanningTrees trees(cloud, links, normals);
    trees.grow(part(progress, 0, 0.7));
    const bool sided = !trees.hasSeam(part(progress, 0.7, 0.8));
    std::vector<std::uint32_t> start(n + 1), members(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto [root, flip] = trees.look(i);
        if (flip)
            normals[i] = -normals[i];
        ++start[root];
    }
    for (std::size_t i = 0; i < n; ++i)
        start[i + 1] += start[i]; // where each ends
    for (auto i = static_cast<std::uint32_t>(n); i-- > 0;)
        members[--start[trees.look(i).root]] = i; // and then begins
    const Outside outside(cloud.positions());
    for (std::size_t root = 0; root < n; ++root) {
        const std::span<const std::uint32_t> component(members.data() + start[root], start[root + 1] - start[root]);
        if (component.empty())
            continue;
        progress.step(0.8 + 0.2 * static_cast<double>(root) / static_cast<double>(n), orienting);
        if (outside.inward(normals, component))
            for (const std::uint32_t i : component)
                normals[i] = -normals[i];
    }
    return sided;
}

} // namespace process
