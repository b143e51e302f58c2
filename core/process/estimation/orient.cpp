// Consistent orientation: the minimum spanning tree of unlikeness over the neighbour graph [Hoppe92],
// with a flip rule (process/README 2.2) that knows the edge between the two points.
#include "core/base/clones.h"
#include "core/base/disjoint_sets.h"
#include "core/base/radix_sort.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/outside.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace process {

namespace {

/// Edges in classes of likeness: as fine as float normals of a scan mean anything, and sorted in one pass.
constexpr int classBits = 14;
constexpr std::size_t classes = std::size_t(1) << classBits;

constexpr const char* orienting = "Orienting normals";

/// One point and its neighbours, or what else is beside it, in lanes.
struct Beside {
    static constexpr int most = 16;
    base::Vec3f a, na;
    float x[most], y[most], z[most], nx[most], ny[most], nz[most];
};

/// Of edges to a point's neighbours, in lanes.
struct Likeness {
    std::int32_t flip[Beside::most];   ///< 1 where the normal must be turned
    std::int32_t unlike[Beside::most]; ///< 0 certain to classes - 1
};

/// Compares the normal at b with the one that a circular arc from a to b would carry there, the normal at a mirrored in
/// the plane halfway: exact on spheres and cylinders, and right across sharp edges, where n_a . n_b is 0. An edge along
/// the normals joins two layers or two sides of something thin, and nobody can tell which: it comes last. The same bits
/// from a to b and from b to a.
POINTCLAY_CLONES
void likeness(const Beside& b, Likeness& out) {
    for (int k = 0; k < Beside::most; ++k) {
        const float ex = b.x[k] - b.a.x, ey = b.y[k] - b.a.y, ez = b.z[k] - b.a.z;
        const float l = std::sqrt(ex * ex + ey * ey + ez * ez);
        const bool far = l > 0 && l <= std::numeric_limits<float>::max();
        const float ux = far ? ex / l : 0, uy = far ? ey / l : 0, uz = far ? ez / l : 0;
        const float alongA = b.na.x * ux + b.na.y * uy + b.na.z * uz;
        const float alongB = b.nx[k] * ux + b.ny[k] * uy + b.nz[k] * uz;
        const float arc = b.na.x * b.nx[k] + b.na.y * b.ny[k] + b.na.z * b.nz[k] - 2 * alongA * alongB;
        const float steepA = alongA * alongA, steepB = alongB * alongB;
        const float unlike = 1 - std::abs(arc) * (1 - (steepA < steepB ? steepB : steepA));
        const float clamped = unlike < 0 ? 0 : 1 < unlike ? 1 : unlike;
        out.flip[k] = arc < 0;
        out.unlike[k] = static_cast<std::int32_t>(clamped * (classes - 1));
    }
}

/// Edges this unlike or less are certain: on two-sided scans, raw ones included, next to none of them contradicts the
/// others (at most 0.07 sqrt(n) points, found on 30 models), while a Moebius strip's seam of them cannot vanish.
constexpr std::int32_t certain = classes / 20;
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
        : m_positions(cloud.positions()), m_links(links), m_normals(normals), m_trees(cloud.size()),
          m_along(links.size()) {}

    void grow(const base::Progress& progress) {
        compare(part(progress, 0, 0.3));
        const std::vector<std::size_t> before = countsBelow();
        std::size_t room = std::max<std::size_t>(m_links.size() / 8, 1), begin = 0;
        while (begin < classes) {
            // As many classes as make so many edges, at least one. The more points are joined, the fewer are left of
            // the edges that there are.
            std::size_t end = begin + 1;
            while (end < classes && before[end + 1] - before[begin] <= room)
                ++end;
            const double done = static_cast<double>(begin) / classes;
            join(begin, end, part(progress, 0.3 + 0.7 * done, 0.3 + 0.7 * static_cast<double>(end) / classes));
            begin = end;
            room *= 2;
        }
    }

    /// Is there a seam, along which certain edges contradict the signs that the trees gave?
    bool hasSeam(const base::Progress& progress) const {
        std::vector<std::vector<std::uint32_t>> parts(base::chunkCount(m_links.size(), grain));
        forSlabs(progress, [&](std::size_t i, std::size_t chunk) {
            const auto a = m_trees.look(static_cast<std::uint32_t>(i));
            const NeighbourTable::Row row = m_links.row(i);
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                if (unlikeOf(m_along[i][k]) >= certain)
                    continue;
                const auto b = m_trees.look(row[k]);
                if (a.root == b.root && (a.opposite != b.opposite) != flipOf(m_along[i][k]))
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

    void forgetEdges() { m_along = {}; }
    base::ParitySets::Member look(std::uint32_t i) const { return m_trees.look(i); }

  private:
    static constexpr std::size_t grain = 8192, slab = 64 * grain;

    /// An edge's class and its flip in one word.
    using Along = std::array<std::uint16_t, NeighbourTable::most>;
    static constexpr std::uint16_t flipBit = classes;
    static std::int32_t unlikeOf(std::uint16_t along) { return along & (flipBit - 1); }
    static bool flipOf(std::uint16_t along) { return (along & flipBit) != 0; }

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

    void compare(const base::Progress& progress) {
        forSlabs(progress, [&](std::size_t i, std::size_t) {
            const NeighbourTable::Row row = m_links.row(i);
            Beside beside{};
            Likeness found;
            beside.a = m_positions[i], beside.na = m_normals[i];
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                const base::Vec3f &p = m_positions[row[k]], &n = m_normals[row[k]];
                beside.x[k] = p.x, beside.y[k] = p.y, beside.z[k] = p.z;
                beside.nx[k] = n.x, beside.ny[k] = n.y, beside.nz[k] = n.z;
            }
            likeness(beside, found);
            for (std::size_t k = 0; k < NeighbourTable::most; ++k)
                m_along[i][k] = static_cast<std::uint16_t>(found.unlike[k] + found.flip[k] * flipBit);
        });
    }

    /// About how many edges are in the classes below each, from a sixteenth of the points.
    std::vector<std::size_t> countsBelow() const {
        constexpr std::size_t step = 16;
        std::vector<std::size_t> counts(classes + 1);
        for (std::size_t i = 0; i < m_links.size(); i += step)
            for (std::size_t k = 0; k < m_links.count(); ++k)
                counts[static_cast<std::size_t>(unlikeOf(m_along[i][k])) + 1] += step;
        for (std::size_t c = 0; c < classes; ++c)
            counts[c + 1] += counts[c];
        return counts;
    }

    /// The edges of the classes that join something. That an edge may be found from both its ends does no harm: the
    /// second time it joins nothing.
    std::vector<Edge> edgesOf(std::int32_t begin, std::int32_t end, const base::Progress& progress) const {
        std::vector<std::vector<Edge>> parts(base::chunkCount(m_links.size(), grain));
        forSlabs(progress, [&](std::size_t i, std::size_t chunk) {
            const Along& along = m_along[i];
            const auto isMeant = [&](std::uint16_t edge) { return unlikeOf(edge) >= begin && unlikeOf(edge) < end; };
            bool any = false;
            for (std::size_t k = 0; k < m_links.count(); ++k)
                any |= isMeant(along[k]);
            if (!any)
                return;
            const NeighbourTable::Row row = m_links.row(i);
            const auto root = m_trees.look(static_cast<std::uint32_t>(i)).root;
            for (std::size_t k = 0; k < m_links.count(); ++k)
                if (isMeant(along[k]) && m_trees.look(row[k]).root != root)
                    parts[chunk].push_back({static_cast<std::uint32_t>(i), row[k],
                                            static_cast<std::uint16_t>(unlikeOf(along[k])), flipOf(along[k])});
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
        return edges;
    }

    void join(std::size_t begin, std::size_t end, const base::Progress& progress) {
        std::vector<Edge> edges =
            edgesOf(static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end), part(progress, 0, 0.6));
        base::radixSort(edges, classBits, [](const Edge& edge) { return edge.unlike; });
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (e % 131072 == 0)
                progress.step(0.7 + 0.3 * static_cast<double>(e) / static_cast<double>(edges.size()), orienting);
            m_trees.relate(edges[e].a, edges[e].b, edges[e].flip);
        }
        if (!edges.empty())
            base::parallelFor(m_links.size(), grain,
                              [&](std::size_t i) { m_trees.shorten(static_cast<std::uint32_t>(i)); });
    }

    std::span<const base::Vec3f> m_positions;
    const NeighbourTable& m_links;
    std::span<const base::Vec3f> m_normals;
    base::ParitySets m_trees;
    base::LargeArray<Along> m_along;
};

} // namespace

bool orient(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
            const base::Progress& progress) {
    const std::size_t n = cloud.size();
    if (n < 2)
        return true;
    SpanningTrees trees(cloud, links, normals);
    trees.grow(part(progress, 0, 0.7));
    const bool sided = !trees.hasSeam(part(progress, 0.7, 0.8));
    trees.forgetEdges();
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
