#include "core/cells/creases/link_faces.h"

#include "core/base/cancel_scope.h"
#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

namespace cells {

namespace {

constexpr std::size_t fewest = 8;       ///< surfels of a face
constexpr double leastDepth = 0.75;     ///< spacings from its creases to its middle: a quarter of the width and more
constexpr std::size_t fewestAcross = 3; ///< links where creases leave a gap: fewer are of faces that touch at a tip
constexpr double neck = 0.5;            ///< of the depth of the shallower of two faces: what is narrower parts them

class FaceFinder {
  public:
    explicit FaceFinder(SurfelLinks& links) : m_links(links) {}

    LinkFaces run() {
        LinkFaces out;
        for (int round = 0; round < mostRounds; ++round) {
            base::CancelScope::check();
            findEdges();
            findFaces();
            joinLeaks();
            const std::size_t narrow = giveUpNarrow();
            out.narrow += narrow;
            if (narrow == 0)
                break;
        }
        closeGaps();
        out.faces = number();
        return out;
    }

  private:
    static constexpr int mostRounds = 4;
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    struct Border {
        std::size_t cut = 0, uncut = 0;
    };

    void findEdges() {
        m_edge.assign(m_links.size(), false);
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            m_links.forLinks(i, [&](std::uint32_t, Cut cut) { m_edge[i] = m_edge[i] || cut == Cut::Crease; });
    }

    /// A watershed of the depth, which is how far a surfel is from those at creases: faces begin where it is largest
    /// and grow downwards; where two meet they are one unless what is between them is a neck, as at a gap in a line.
    void findFaces() {
        m_depth.assign(m_links.size(), std::numeric_limits<double>::infinity());
        Queue queue;
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            if (m_edge[i]) {
                m_depth[i] = 0;
                queue.emplace(0.0, i);
            }
        walk(queue, m_depth);
        std::vector<std::uint32_t> order(m_links.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return m_depth[a] > m_depth[b]; });
        base::DisjointSets sets(m_links.size());
        std::vector<double> peak = m_depth; // of each set, at its root
        std::vector<bool> known(m_links.size());
        const auto join = [&](std::uint32_t a, std::uint32_t b) {
            const double highest = std::max(peak[a], peak[b]);
            sets.join(a, b);
            peak[sets.find(a)] = highest;
        };
        for (const std::uint32_t i : order) {
            known[i] = true;
            std::uint32_t uphill = i; // the neighbour that is deepest
            m_links.forLinks(i, [&](std::uint32_t j, Cut cut) {
                if (cut == Cut::None && known[j] && (uphill == i || m_depth[j] > m_depth[uphill]))
                    uphill = j;
            });
            if (uphill != i)
                join(sets.find(i), sets.find(uphill));
            m_links.forLinks(i, [&](std::uint32_t j, Cut cut) {
                if (cut != Cut::None || !known[j])
                    return;
                const std::uint32_t a = sets.find(i), b = sets.find(j);
                if (a != b && m_depth[i] >= neck * std::min(peak[a], peak[b]))
                    join(a, b);
            });
        }
        m_face.resize(m_links.size());
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            m_face[i] = sets.find(i);
    }

    using Entry = std::pair<double, std::uint32_t>;
    using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

    /// Shortest ways in spacings over links of the surface.
    void walk(Queue& queue, std::vector<double>& way) const {
        for (std::size_t steps = 0; !queue.empty(); ++steps) {
            if (steps % 4096 == 0)
                base::CancelScope::check();
            const auto [far, i] = queue.top();
            queue.pop();
            if (far > way[i])
                continue;
            m_links.forLinks(i, [&, far = far, i = i](std::uint32_t j, Cut cut) {
                const double further = far + base::distance(m_links.at(i), m_links.at(j)) / m_links.spacing(i);
                if (cut != Cut::None || !(further < way[j]))
                    return;
                way[j] = further;
                queue.emplace(further, j);
            });
        }
    }

    std::map<Pair, Border> borders() const {
        std::map<Pair, Border> out;
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            m_links.forLinks(i, [&](std::uint32_t j, Cut cut) {
                if (j > i || m_face[i] == m_face[j] || cut == Cut::Wall)
                    return;
                Border& border = out[std::minmax(m_face[i], m_face[j])];
                ++(cut == Cut::Crease ? border.cut : border.uncut);
            });
        return out;
    }
    void joinFaces(base::DisjointSets& sets) {
        for (std::uint32_t& face : m_face)
            face = sets.find(face);
    }

    /// Necks between creases part faces that are one: where more links go across than are cut.
    void joinLeaks() {
        base::DisjointSets sets(m_links.size());
        std::map<std::uint32_t, std::size_t> sizes;
        for (const std::uint32_t face : m_face)
            ++sizes[face];
        struct Join {
            bool small;
            double share;
            Pair pair;
            bool operator<(const Join& o) const {
                return small != o.small ? small < o.small : share != o.share ? share > o.share : pair < o.pair;
            }
        };
        std::vector<Join> joins;
        for (const auto& [pair, border] : borders()) {
            const bool small = std::min(sizes[pair.first], sizes[pair.second]) < fewest;
            const double share = static_cast<double>(border.uncut) / static_cast<double>(border.uncut + border.cut);
            if (small || (share > 0.5 && border.uncut >= fewestAcross))
                joins.push_back({small, share, pair});
        }
        std::vector<bool> small(m_links.size());
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            small[i] = sizes[m_face[i]] < fewest;
        std::sort(joins.begin(), joins.end());
        for (const Join& each : joins) {
            const std::uint32_t a = sets.find(each.pair.first), b = sets.find(each.pair.second);
            if (a == b || (each.small && std::min(sizes[a], sizes[b]) >= fewest))
                continue; // grown by now
            sets.join(a, b);
            sizes[sets.find(a)] = sizes[a] + sizes[b];
        }
        joinFaces(sets);
        // what cut off so few surfels is no crease
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            for (std::uint32_t e = m_links.begin(i); small[i] && e < m_links.end(i); ++e)
                if (m_links.link(e).cut == Cut::Crease && m_face[i] == m_face[m_links.link(e).other])
                    m_links.cut(e, Cut::None);
    }

    /// Faces that are nowhere wide enough; the creases around them are none that could be told.
    std::size_t giveUpNarrow() {
        std::vector<double> depth(m_links.size(), std::numeric_limits<double>::infinity());
        Queue queue;
        for (std::uint32_t i = 0; i < m_links.size(); ++i) {
            // the crease is about half way to the nearest surfel across
            m_links.forLinks(i, [&](std::uint32_t j, Cut cut) {
                if (cut == Cut::Crease && m_face[i] != m_face[j])
                    depth[i] =
                        std::min(depth[i], base::distance(m_links.at(i), m_links.at(j)) / m_links.spacing(i) / 2);
            });
            if (depth[i] < std::numeric_limits<double>::infinity())
                queue.emplace(depth[i], i);
        }
        walk(queue, depth);
        std::map<std::uint32_t, double> deepest;
        for (std::uint32_t i = 0; i < m_links.size(); ++i) {
            double& most = deepest.emplace(m_face[i], 0).first->second;
            most = std::max(most, depth[i]);
        }
        std::size_t out = 0;
        for (const auto& [face, most] : deepest)
            out += most < leastDepth ? 1 : 0;
        if (out == 0)
            return 0;
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            for (std::uint32_t e = m_links.begin(i); e < m_links.end(i); ++e)
                if (m_links.link(e).cut == Cut::Crease &&
                    std::min(deepest[m_face[i]], deepest[m_face[m_links.link(e).other]]) < leastDepth)
                    m_links.cut(e, Cut::None);
        return out;
    }

    void closeGaps() {
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            for (std::uint32_t e = m_links.begin(i); e < m_links.end(i); ++e)
                if (m_links.link(e).cut == Cut::None && m_face[i] != m_face[m_links.link(e).other])
                    m_links.cut(e, Cut::Crease);
    }

    std::vector<std::uint32_t> number() const {
        std::map<std::uint32_t, std::uint32_t> numbers;
        std::vector<std::uint32_t> out;
        for (const std::uint32_t face : m_face)
            out.push_back(numbers.emplace(face, static_cast<std::uint32_t>(numbers.size())).first->second);
        return out;
    }

    SurfelLinks& m_links;
    std::vector<bool> m_edge;
    std::vector<double> m_depth; ///< spacings
    std::vector<std::uint32_t> m_face;
};

} // namespace

LinkFaces facesOfLinks(SurfelLinks& links) {
    return FaceFinder(links).run();
}

} // namespace cells
