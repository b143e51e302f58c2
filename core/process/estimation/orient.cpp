// Consistent orientation: the minimum spanning tree of unlikeness over the neighbour graph [Hoppe92],
// with a flip rule (process/README 2.2) that knows the edge between the two points.
#include "core/base/clones.h"
#include "core/base/disjoint_sets.h"
#include "core/base/large_array.h"
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

/// An edge as chunks hand it on, in one word: the point that it was found from, counted from the chunk's first, its
/// class, whether it flips, and the other point.
class Edge {
  public:
    Edge() = default;
    Edge(std::uint32_t local, std::int32_t unlike, bool flip, std::uint32_t to)
        : m_word(std::uint64_t(local) << 47 | std::uint64_t(unlike) << 33 | std::uint64_t(flip) << 32 | to) {}
    std::uint32_t local() const { return static_cast<std::uint32_t>(m_word >> 47); }
    std::uint32_t unlike() const { return static_cast<std::uint32_t>(m_word >> 33) & (classes - 1); }
    bool flip() const { return (m_word >> 32 & 1) != 0; }
    std::uint32_t to() const { return static_cast<std::uint32_t>(m_word); }

  private:
    std::uint64_t m_word;
};

/// Kruskal's minimum spanning trees of the neighbour graph, with the flips along their edges. Edges come by classes of
/// likeness, those of a class in the order of the points along the curve. Chunks of points first find the trees of what
/// lies inside of them: an edge that closes a circle there is the last one of a circle, in the whole as well, and is in
/// no tree. What is left, little more than an edge a point, is sorted and joined.
class SpanningTrees {
  public:
    SpanningTrees(const Cloud& cloud, const NeighbourTable& links, std::span<const base::Vec3f> normals)
        : m_positions(cloud.positions()), m_links(links), m_normals(normals), m_trees(cloud.size()) {}

    void grow(const base::Progress& progress) {
        std::vector<std::vector<Edge>> parts(base::chunkCount(m_links.size(), grain));
        forChunks(part(progress, 0, 0.7), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            parts[chunk] = candidates(begin, end);
        });
        progress.step(0.7, orienting);
        const base::LargeArray<Joint> joints = sorted(parts);
        for (std::size_t k = 0; k < joints.size(); ++k) {
            if (k % 131072 == 0)
                progress.step(0.75 + 0.25 * static_cast<double>(k) / static_cast<double>(joints.size()), orienting);
            m_trees.relate(joints[k].a, joints[k].b >> 1, (joints[k].b & 1) != 0);
        }
        base::parallelFor(m_links.size(), grain,
                          [&](std::size_t i) { m_trees.shorten(static_cast<std::uint32_t>(i)); });
    }

    /// Is there a seam, along which certain edges contradict the signs that the trees gave?
    bool hasSeam(const base::Progress& progress) const {
        std::vector<std::vector<std::uint32_t>> parts(base::chunkCount(m_links.size(), grain));
        forChunks(progress, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            forRows(begin, end, [&](std::uint32_t i, const NeighbourTable::Row& row, const Likeness& along) {
                const auto a = m_trees.look(i);
                for (std::size_t k = 0; k < m_links.count(); ++k) {
                    if (along.unlike[k] >= certain)
                        continue;
                    const auto b = m_trees.look(row[k]);
                    if (a.root == b.root && (a.opposite != b.opposite) != (along.flip[k] != 0))
                        parts[chunk].insert(parts[chunk].end(), {i, row[k]});
                }
            });
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
    static constexpr std::size_t grain = 16384, slab = 16 * grain;
    struct Joint {
        std::uint32_t a, b; ///< b << 1 | flip
    };

    /// body(begin, end, chunk) for all points, in parallel.
    template <class Body>
    void forChunks(const base::Progress& progress, const Body& body) const {
        const std::size_t n = m_links.size();
        for (std::size_t from = 0; from < n; from += slab) {
            progress.step(static_cast<double>(from) / static_cast<double>(n), orienting);
            base::parallelChunks(std::min(slab, n - from), grain,
                                 [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                     body(from + begin, from + end, from / grain + chunk);
                                 });
        }
    }

    /// body(i, neighbours, likeness) for a range of points.
    template <class Body>
    void forRows(std::size_t begin, std::size_t end, const Body& body) const {
        Beside beside{};
        Likeness along;
        for (std::size_t i = begin; i < end; ++i) {
            const NeighbourTable::Row row = m_links.row(i);
            beside.a = m_positions[i], beside.na = m_normals[i];
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                const base::Vec3f &p = m_positions[row[k]], &n = m_normals[row[k]];
                beside.x[k] = p.x, beside.y[k] = p.y, beside.z[k] = p.z;
                beside.nx[k] = n.x, beside.ny[k] = n.y, beside.nz[k] = n.z;
            }
            likeness(beside, along);
            body(static_cast<std::uint32_t>(i), row, along);
        }
    }

    /// The chunk's edges that may be in a tree, in the order of its points. That an edge may be found from both its
    /// ends does no harm: it has the same bits from both, and the second time it joins nothing.
    std::vector<Edge> candidates(std::size_t begin, std::size_t end) const {
        std::vector<Edge> edges;
        edges.reserve((end - begin) * m_links.count());
        std::vector<std::uint32_t> next(classes + 1);
        forRows(begin, end, [&](std::uint32_t i, const NeighbourTable::Row& row, const Likeness& along) {
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                edges.emplace_back(static_cast<std::uint32_t>(i - begin), along.unlike[k], along.flip[k] != 0, row[k]);
                ++next[edges.back().unlike() + 1];
            }
        });
        for (std::size_t c = 0; c < classes; ++c)
            next[c + 1] += next[c];
        std::vector<std::uint32_t> order(edges.size());
        for (std::uint32_t e = 0; e < edges.size(); ++e)
            order[next[edges[e].unlike()]++] = e;
        base::DisjointSets inside(end - begin);
        std::vector<std::uint8_t> mayJoin(edges.size());
        for (const std::uint32_t e : order) {
            const std::uint32_t to = edges[e].to();
            mayJoin[e] =
                to < begin || to >= end || inside.join(edges[e].local(), to - static_cast<std::uint32_t>(begin));
        }
        std::vector<Edge> out;
        out.reserve(static_cast<std::size_t>(std::count(mayJoin.begin(), mayJoin.end(), 1)));
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (mayJoin[e])
                out.push_back(edges[e]);
        return out;
    }

    /// By class, those of one in the order that they have. Empties the parts.
    static base::LargeArray<Joint> sorted(std::vector<std::vector<Edge>>& parts) {
        std::vector<std::size_t> next(classes + 1);
        std::size_t count = 0;
        for (const auto& part : parts) {
            count += part.size();
            for (const Edge& edge : part)
                ++next[edge.unlike() + 1];
        }
        for (std::size_t c = 0; c < classes; ++c)
            next[c + 1] += next[c];
        base::LargeArray<Joint> out(count);
        for (std::size_t chunk = 0; chunk < parts.size(); ++chunk) {
            for (const Edge& edge : parts[chunk])
                out[next[edge.unlike()]++] = {static_cast<std::uint32_t>(chunk * grain) + edge.local(),
                                              edge.to() << 1 | (edge.flip() ? 1u : 0u)};
            std::vector<Edge>().swap(parts[chunk]);
        }
        return out;
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
