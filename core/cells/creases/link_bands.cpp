#include "core/cells/creases/link_bands.h"

#include "core/base/cancel_scope.h"
#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>

namespace cells {

namespace {

constexpr double bandWidth = 10;      ///< spacings
constexpr std::size_t fewestEnds = 6; ///< of links that are cut: a shorter crease is none

class BandSplit {
  public:
    BandSplit(const SurfelLinks& links, std::span<const std::uint32_t> faces)
        : m_links(links), m_faces(faces), m_cells(faces.begin(), faces.end()) {}

    std::vector<std::uint32_t> run() {
        findEnds();
        if (!m_ends.empty())
            grow(split());
        return std::move(m_cells);
    }

  private:
    bool within(std::uint32_t a, std::uint32_t b, Cut is, Cut wanted) const {
        return is == wanted && m_faces[a] == m_faces[b];
    }

    void findEnds() {
        m_isEnd.assign(m_links.size(), false);
        for (std::uint32_t a = 0; a < m_links.size(); ++a) {
            m_links.forLinks(
                a, [&](std::uint32_t b, Cut cut) { m_isEnd[a] = m_isEnd[a] || within(a, b, cut, Cut::Crease); });
            if (m_isEnd[a])
                m_ends.push_back(a);
        }
    }

    /// Parities over the ends of links that are cut: first those links, which turn, then the others between these
    /// ends, flattest first, which do not. The other order joins both sides around the end of the crease.
    std::vector<std::uint32_t> split() {
        struct Flat {
            float turn;
            std::uint32_t a, b;
            bool operator<(const Flat& o) const {
                return turn != o.turn ? turn < o.turn : a != o.a ? a < o.a : b < o.b;
            }
        };
        base::ParitySets sides(m_links.size());
        std::vector<Flat> others;
        for (const std::uint32_t a : m_ends)
            m_links.forLinks(a, [&](std::uint32_t b, Cut cut) {
                if (b < a || !m_isEnd[b] || m_faces[a] != m_faces[b])
                    return;
                if (cut == Cut::Crease)
                    sides.relate(a, b, true);
                else if (cut == Cut::None)
                    others.push_back({1 - dot(m_links.surfel(a).normal, m_links.surfel(b).normal), a, b});
            });
        std::sort(others.begin(), others.end());
        for (const Flat& link : others)
            sides.relate(link.a, link.b, false);

        std::map<std::uint32_t, std::size_t> sizes;
        for (const std::uint32_t a : m_ends)
            ++sizes[sides.find(a).root];
        std::uint32_t next = 1 + *std::max_element(m_faces.begin(), m_faces.end());
        std::map<std::uint32_t, std::uint32_t> bands; // the first of two, by root
        for (const auto& [root, size] : sizes)
            if (size >= fewestEnds) {
                bands.emplace(root, next);
                next += 2;
            }
        std::vector<std::uint32_t> seeds;
        for (const std::uint32_t a : m_ends) {
            const auto [root, opposite] = sides.find(a);
            const auto at = bands.find(root);
            if (at == bands.end())
                continue;
            m_cells[a] = at->second + (opposite ? 1 : 0);
            seeds.push_back(a);
        }
        return seeds;
    }

    /// Shortest ways over links of the surface.
    void grow(const std::vector<std::uint32_t>& seeds) {
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        std::map<std::uint32_t, double> known;
        for (const std::uint32_t a : seeds) {
            known[a] = 0;
            queue.emplace(0.0, a);
        }
        for (std::size_t steps = 0; !queue.empty(); ++steps) {
            if (steps % 4096 == 0)
                base::CancelScope::check();
            const auto [way, a] = queue.top();
            queue.pop();
            if (way > known.at(a))
                continue;
            m_links.forLinks(a, [&, way = way, a = a](std::uint32_t b, Cut cut) {
                if (!within(a, b, cut, Cut::None))
                    return;
                const double further = way + base::distance(m_links.at(a), m_links.at(b)) / m_links.spacing(a);
                const auto at = known.find(b);
                if (further > bandWidth || (at != known.end() && at->second <= further))
                    return;
                known[b] = further;
                m_cells[b] = m_cells[a];
                queue.emplace(further, b);
            });
        }
    }

    const SurfelLinks& m_links;
    std::span<const std::uint32_t> m_faces;
    std::vector<bool> m_isEnd;
    std::vector<std::uint32_t> m_ends;
    std::vector<std::uint32_t> m_cells;
};

} // namespace

std::vector<std::uint32_t> splitAtCreases(const SurfelLinks& links, std::span<const std::uint32_t> faces) {
    return BandSplit(links, faces).run();
}

} // namespace cells
