#include "core/process/estimation/orientation/orientation_trees.h"

#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace process {

namespace {

constexpr const char* orienting = "Orienting normals";
constexpr std::size_t grain = 16384, slab = 16 * grain;

/// Edges this unlike or less are certain: on two-sided scans, raw ones included, next to none of them contradicts the
/// others (at most 0.07 sqrt(n) points, found on 30 models), while a Moebius strip's seam of them cannot vanish.
constexpr std::int32_t certain = unlikeClasses / 20;
/// But not where points stand among layers, which noise of a fifth of the spacing does not make of one.
constexpr auto amongLayers = static_cast<std::int32_t>(0.08 * unlikeClasses);
constexpr double seamLength = 0.3; ///< in sqrt(n) points, from which there is a seam
constexpr std::size_t leastSeam = 4;

/// Edges at points that stand among layers come late (process/README 2.2): so much of the mean squared step to their
/// neighbours is added to what edges are sorted by, and the whole is put into the classes at half the scale.
constexpr float layersWeigh = 2;
constexpr std::int32_t scale = 2;

/// Strays stand outermost, and their normals mean nothing: only points are asked that lie on a surface with others,
/// with so many of which they agree so well (process/README 2.3).
constexpr std::int32_t agreed = unlikeClasses * 3 / 10;
constexpr int leastAgreed = 4, rounds = 4;
constexpr std::size_t smallSheet = 10; ///< times as large is another: strays by chance on a sheet have no say
constexpr std::uint32_t nowhere = ~0u;
/// How far winding numbers may be from those of a body that says which side is outside, whatever the outermost points
/// say, and where these say nothing.
constexpr double certainBody = 0.2, likelyBody = 0.3;

/// body(begin, end, chunk) for n points, in parallel.
template <class Body>
void forChunks(std::size_t n, const base::Progress& progress, const Body& body) {
    for (std::size_t from = 0; from < n; from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(n), orienting);
        base::parallelChunks(std::min(slab, n - from), grain,
                             [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                 body(from + begin, from + end, from / grain + chunk);
                             });
    }
}

} // namespace

/// An edge as chunks hand it on, in one word: the point that it was found from, counted from the chunk's first, its
/// class, whether it flips, and the other point.
class OrientationTrees::Edge {
  public:
    Edge() = default;
    Edge(std::uint32_t local, std::int32_t unlike, bool flip, std::uint32_t to)
        : m_word(std::uint64_t(local) << 47 | std::uint64_t(unlike) << 33 | std::uint64_t(flip) << 32 | to) {}
    std::uint32_t local() const { return static_cast<std::uint32_t>(m_word >> 47); }
    std::uint32_t unlike() const { return static_cast<std::uint32_t>(m_word >> 33) & (unlikeClasses - 1); }
    bool flip() const { return (m_word >> 32 & 1) != 0; }
    std::uint32_t to() const { return static_cast<std::uint32_t>(m_word); }

  private:
    std::uint64_t m_word;
};

OrientationTrees::OrientationTrees(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
                                   const base::Progress& progress)
    : m_positions(cloud.positions()), m_normals(normals), m_links(m_positions, links, normals), m_signs(cloud.size()) {
    lookForLayers(part(progress, 0, 0.4));
    std::vector<std::vector<Edge>> parts(base::chunkCount(m_links.size(), grain));
    forChunks(m_links.size(), part(progress, 0.4, 0.95),
              [&](std::size_t begin, std::size_t end, std::size_t chunk) { parts[chunk] = candidates(begin, end); });
    progress.step(0.95, orienting);
    sort(parts);
}

/// At the tip of an acute wedge, and in thin parts, both sides are among the neighbours: the plane through these is
/// neither's, and a chain of small turns leads round the tip, the wrong way. What later steps ask of edges is kept.
void OrientationTrees::lookForLayers(const base::Progress& progress) {
    m_layered = base::LargeArray<std::uint16_t>(m_links.size());
    m_alike = base::LargeArray<std::uint32_t>(m_links.size());
    forChunks(m_links.size(), progress, [&](std::size_t begin, std::size_t end, std::size_t) {
        m_links.forRows(begin, end, [&](std::uint32_t i, const NeighbourTable::Row&, const Likeness& along) {
            float sum = 0;
            std::uint32_t alike = 0;
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                sum += along.stepSq[k];
                const Alike each = along.unlike[k] >= agreed    ? Alike::No
                                   : along.unlike[k] >= certain ? Alike::Agreed
                                   : along.flip[k] != 0         ? Alike::CertainlyOpposite
                                                                : Alike::CertainlySame;
                alike |= static_cast<std::uint32_t>(each) << 2 * k;
            }
            const auto layered = static_cast<std::int32_t>(layersWeigh * sum / static_cast<float>(m_links.count()) *
                                                           static_cast<float>(unlikeClasses));
            m_layered[i] = static_cast<std::uint16_t>(std::min(layered, 0xffff));
            m_alike[i] = alike;
        });
    });
}

/// The chunk's edges that may be in a tree, in the order of its points. Most edges are found from both their ends, with
/// the same bits, and the second time they would join nothing.
std::vector<OrientationTrees::Edge> OrientationTrees::candidates(std::size_t begin, std::size_t end) const {
    std::vector<Edge> edges;
    edges.reserve((end - begin) * m_links.count());
    std::vector<std::uint32_t> next(unlikeClasses + 1);
    m_links.forRows(begin, end, [&](std::uint32_t i, const NeighbourTable::Row& row, const Likeness& along) {
        for (std::size_t k = 0; k < m_links.count(); ++k) {
            if (m_links.foundBefore(i, row[k]))
                continue;
            const std::int32_t order = (along.unlike[k] + layeredBetween(i, row[k])) / scale;
            edges.emplace_back(static_cast<std::uint32_t>(i - begin),
                               std::min(order, static_cast<std::int32_t>(unlikeClasses) - 1), along.flip[k] != 0,
                               row[k]);
            ++next[edges.back().unlike() + 1];
        }
    });
    for (std::size_t c = 0; c < unlikeClasses; ++c)
        next[c + 1] += next[c];
    std::vector<std::uint32_t> order(edges.size());
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        order[next[edges[e].unlike()]++] = e;
    base::DisjointSets inside(end - begin);
    std::vector<std::uint8_t> mayJoin(edges.size());
    for (const std::uint32_t e : order) {
        const std::uint32_t to = edges[e].to();
        mayJoin[e] = to < begin || to >= end || inside.join(edges[e].local(), to - static_cast<std::uint32_t>(begin));
    }
    std::vector<Edge> out;
    out.reserve(static_cast<std::size_t>(std::count(mayJoin.begin(), mayJoin.end(), 1)));
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (mayJoin[e])
            out.push_back(edges[e]);
    return out;
}

/// By class, those of one in the order that they have. Empties the parts.
void OrientationTrees::sort(std::vector<std::vector<Edge>>& parts) {
    std::vector<std::size_t> next(unlikeClasses + 1);
    std::size_t count = 0;
    for (const auto& part : parts) {
        count += part.size();
        for (const Edge& edge : part)
            ++next[edge.unlike() + 1];
    }
    for (std::size_t c = 0; c < unlikeClasses; ++c)
        next[c + 1] += next[c];
    m_joints = base::LargeArray<Joint>(count);
    for (std::size_t chunk = 0; chunk < parts.size(); ++chunk) {
        for (const Edge& edge : parts[chunk])
            m_joints[next[edge.unlike()]++] = {static_cast<std::uint32_t>(chunk * grain) + edge.local(),
                                               edge.to() << 1 | (edge.flip() ? 1u : 0u)};
        std::vector<Edge>().swap(parts[chunk]);
    }
    m_classEnd = std::move(next); // where each began, one by one moved to its end
}

/// How many joints are less unlike: the first ones.
std::size_t OrientationTrees::edgesBelow(double unlike) const {
    const double wanted = std::ceil(unlike / scale * static_cast<double>(unlikeClasses));
    const auto below = static_cast<std::size_t>(std::clamp(wanted, 0.0, static_cast<double>(unlikeClasses)));
    return below > 0 ? m_classEnd[below - 1] : 0;
}

void OrientationTrees::joinPatches(double unlike, std::size_t most, const base::Progress& progress) {
    m_signs = base::ParitySets(m_links.size());
    m_joined = 0;
    std::vector<std::uint32_t> size(m_links.size(), 1);
    const std::size_t end = edgesBelow(unlike);
    for (std::size_t k = 0; k < end; ++k) {
        if (k % 131072 == 0)
            progress.step(static_cast<double>(k) / static_cast<double>(end), orienting);
        const Joint& joint = m_joints[k];
        const std::uint32_t a = m_signs.find(joint.a).root, b = m_signs.find(joint.b >> 1).root;
        if (a == b || size[a] + size[b] > most)
            continue;
        m_signs.relate(joint.a, joint.b >> 1, (joint.b & 1) != 0);
        size[std::min(a, b)] = size[a] + size[b]; // the smaller one represents both
    }
}

void OrientationTrees::joinBelow(double unlike, const base::Progress& progress) {
    const std::size_t end = edgesBelow(unlike), begin = m_joined;
    for (; m_joined < end; ++m_joined) {
        if ((m_joined - begin) % 131072 == 0)
            progress.step(static_cast<double>(m_joined - begin) / static_cast<double>(end - begin), orienting);
        const Joint& joint = m_joints[m_joined];
        m_signs.relate(joint.a, joint.b >> 1, (joint.b & 1) != 0);
    }
}

/// What is asked next asks about every point.
void OrientationTrees::shorten() {
    base::parallelFor(m_links.size(), grain, [&](std::size_t i) { m_signs.shorten(static_cast<std::uint32_t>(i)); });
}

bool OrientationTrees::hasSeam(const base::Progress& progress) {
    shorten();
    std::vector<std::vector<std::uint32_t>> parts(base::chunkCount(m_links.size(), grain));
    forChunks(m_links.size(), progress, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            const NeighbourTable::Row row = m_links.row(i);
            const auto a = m_signs.look(i);
            for (std::size_t k = 0; k < m_links.count(); ++k) {
                const Alike alike = alikeness(i, k);
                if (alike < Alike::CertainlySame || layeredBetween(i, row[k]) > amongLayers)
                    continue;
                const auto b = m_signs.look(row[k]);
                if (a.root == b.root && (a.opposite != b.opposite) != (alike == Alike::CertainlyOpposite))
                    parts[chunk].insert(parts[chunk].end(), {i, row[k]});
            }
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

/// Those, still borne out, that no longer have enough others which are, without those that `lost` that in the round
/// before. They lose it now.
std::vector<std::vector<std::uint32_t>> OrientationTrees::losing(const std::vector<std::vector<std::uint32_t>>& lost,
                                                                 std::span<const std::uint16_t> alike,
                                                                 std::span<std::uint8_t> borneOut) const {
    std::vector<std::vector<std::uint32_t>> out(lost.size());
    const auto others = [&](std::uint32_t i, const auto& body) {
        const NeighbourTable::Row row = m_links.row(i);
        for (unsigned bits = alike[i]; bits != 0; bits &= bits - 1)
            body(row[static_cast<std::size_t>(std::countr_zero(bits))]);
    };
    base::parallelFor(lost.size(), 1, [&](std::size_t chunk) {
        for (const std::uint32_t i : lost[chunk])
            others(i, [&](std::uint32_t j) { // which sees i as well
                int found = 0;
                if (borneOut[j] != 0)
                    others(j, [&](std::uint32_t each) { found += borneOut[each]; });
                if (borneOut[j] != 0 && found < leastAgreed)
                    out[chunk].push_back(j);
            });
    });
    for (std::vector<std::uint32_t>& part : out)
        std::erase_if(part, [&](std::uint32_t i) { return std::exchange(borneOut[i], std::uint8_t(0)) == 0; });
    return out;
}

/// Which points lie on a surface together with others: neighbours of neighbours of theirs, with normals alike. Few
/// strays do, by chance, and those that do only with a handful of others. Of each the surface that it lies on, by one
/// of its points, or `nowhere`.
std::vector<std::uint32_t> OrientationTrees::borneOut(const base::Progress& progress) const {
    static_assert(NeighbourTable::most <= 16);
    base::LargeArray<std::uint16_t> alike(m_links.size()); // a bit for each neighbour
    base::LargeArray<std::uint8_t> out(m_links.size());
    std::vector<std::vector<std::uint32_t>> parts(base::chunkCount(m_links.size(), grain));
    forChunks(m_links.size(), progress, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            const NeighbourTable::Row row = m_links.row(i);
            unsigned bits = 0;
            for (std::size_t k = 0; k < m_links.count(); ++k)
                bits |= alikeness(i, k) != Alike::No && m_links.isMutual(i, row[k]) ? 1u << k : 0u;
            alike[i] = static_cast<std::uint16_t>(bits);
            out[i] = std::popcount(bits) >= leastAgreed ? 1 : 0;
            if (out[i] == 0)
                parts[chunk].push_back(i);
        }
    });
    for (int round = 1; round < rounds; ++round)
        parts = losing(parts, alike, out);
    // Chunks join what is inside of them at once, without a look at other chunks' members.
    base::DisjointSets sheets(m_links.size());
    std::vector<std::vector<Joint>> across(base::chunkCount(m_links.size(), grain));
    forChunks(m_links.size(), progress, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
            const NeighbourTable::Row row = m_links.row(i);
            for (std::size_t k = 0; k < m_links.count() && out[i] != 0; ++k)
                if ((alike[i] >> k & out[row[k]]) != 0) {
                    if (row[k] >= begin && row[k] < end)
                        sheets.join(i, row[k]);
                    else if (row[k] < i) // edges are mutual
                        across[chunk].push_back({i, row[k]});
                }
        }
    });
    for (const std::vector<Joint>& each : across)
        for (const Joint& edge : each)
            sheets.join(edge.a, edge.b);
    std::vector<std::uint32_t> sheetOf(m_links.size(), nowhere);
    for (std::uint32_t i = 0; i < m_links.size(); ++i)
        if (out[i] != 0)
            sheetOf[i] = sheets.find(i);
    return sheetOf;
}

/// How the outermost points of a component vote that lie on sheets.
double OrientationTrees::votesFor(const Outside& outside, std::span<const std::uint32_t> component,
                                  std::span<const std::uint32_t> sheetOf) const {
    std::map<std::uint32_t, std::size_t> sizes;
    std::uint32_t last = nowhere; // mostly the next one's, too
    std::size_t* size = nullptr;
    for (const std::uint32_t i : component)
        if (sheetOf[i] != nowhere) {
            if (std::exchange(last, sheetOf[i]) != sheetOf[i])
                size = &sizes[last];
            ++*size;
        }
    std::size_t largest = 0, kept = 0;
    for (const auto& [sheet, count] : sizes)
        largest = std::max(largest, count);
    for (const auto& [sheet, count] : sizes)
        kept += count * smallSheet >= largest ? count : 0;
    if (kept == 0 || kept == component.size())
        return outside.vote(m_normals, component);
    std::vector<std::uint32_t> some;
    some.reserve(kept);
    for (const std::uint32_t i : component)
        if (sheetOf[i] != nowhere && sizes[sheetOf[i]] * smallSheet >= largest)
            some.push_back(i);
    return outside.vote(m_normals, some);
}

void OrientationTrees::takeSigns(Sides given, const std::map<std::uint32_t, WindingSide>& known,
                                 const base::Progress& progress) {
    m_joints = {}, m_layered = {}; // room for what follows
    shorten();
    const std::vector<std::uint32_t> sheetOf = borneOut({nullptr, progress.cancel});
    m_alike = {};
    const std::size_t n = m_links.size();
    base::parallelFor(n, grain, [&](std::size_t i) {
        if (m_signs.look(static_cast<std::uint32_t>(i)).opposite)
            m_normals[i] = -m_normals[i];
    });
    std::vector<std::uint32_t> start(n + 1), members(n);
    for (std::uint32_t i = 0; i < n; ++i)
        ++start[m_signs.look(i).root];
    for (std::size_t i = 0; i < n; ++i)
        start[i + 1] += start[i]; // where each ends
    for (auto i = static_cast<std::uint32_t>(n); i-- > 0;)
        members[--start[m_signs.look(i).root]] = i; // and then begins
    const Outside outside(m_positions);
    const auto mostlyTurned = [&](std::span<const std::uint32_t> component) {
        const auto turned = static_cast<std::size_t>(std::count_if(
            component.begin(), component.end(), [&](std::uint32_t i) { return m_signs.look(i).opposite; }));
        return 2 * turned > component.size();
    };
    for (std::size_t root = 0; root < n; ++root) {
        const std::span<const std::uint32_t> component(members.data() + start[root], start[root + 1] - start[root]);
        if (component.empty())
            continue;
        progress.step(static_cast<double>(root) / static_cast<double>(n), orienting);
        const double votes = votesFor(outside, component, sheetOf);
        const bool unclear = std::abs(votes) < Outside::clear;
        const auto found = known.find(static_cast<std::uint32_t>(root));
        const double off = found == known.end() ? 1 : found->second.off;
        if (off <= certainBody || (unclear && off <= likelyBody) ? found->second.inwards
            : unclear && given == Sides::Mostly                  ? mostlyTurned(component)
                                                                 : outside.inward(m_normals, component, votes))
            for (const std::uint32_t i : component)
                m_normals[i] = -m_normals[i];
    }
}

} // namespace process
