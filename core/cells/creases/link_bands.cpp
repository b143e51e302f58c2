#include "core/cells/creases/link_bands.h"

#include "core/cells/crease_bands.h"

#include <algorithm>
#include <map>
#include <optional>

namespace cells {

namespace {

constexpr double bandWidth = 10;  ///< spacings
constexpr double voteReach = 2.8; ///< spacings: links that tell what is across an older crease

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

    std::vector<std::uint32_t> split() {
        std::vector<BandPairs::Link> crossing;
        std::vector<FlatLink> flat;
        for (const std::uint32_t a : m_ends)
            m_links.forLinks(a, [&](std::uint32_t b, Cut cut) {
                if (b < a || !m_isEnd[b] || m_faces[a] != m_faces[b])
                    return;
                if (cut == Cut::Crease)
                    crossing.emplace_back(a, b);
                else if (cut == Cut::None)
                    flat.push_back({1 - dot(m_links.surfel(a).normal, m_links.surfel(b).normal), a, b});
            });
        BandPairs pairs(m_links.size(), crossing, std::move(flat), m_ends);
        const std::uint32_t first = 1 + *std::max_element(m_faces.begin(), m_faces.end());
        std::vector<std::uint32_t> seeds;
        for (const std::uint32_t a : m_ends)
            if (const auto band = pairs.bandOf(a)) {
                m_cells[a] = first + *band;
                seeds.push_back(a);
            }
        return seeds;
    }

    /// Over links of the surface.
    void grow(const std::vector<std::uint32_t>& seeds) {
        const auto forLinks = [&](std::uint32_t a, const auto& fn) {
            m_links.forLinks(a, [&](std::uint32_t b, Cut cut) {
                if (within(a, b, cut, Cut::None))
                    fn(b, base::distance(m_links.at(a), m_links.at(b)) / m_links.spacing(a));
            });
        };
        growBands(
            seeds, m_cells, forLinks, [](std::uint32_t, std::uint32_t) { return true; }, bandWidth);
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

void moveToCells(const SurfelLinks& links, std::span<const std::uint32_t> cells, std::span<Label> labels) {
    const std::vector<Label> before(labels.begin(), labels.end());
    // What has become of a cell beside surfel i: where a new crease crosses one that is there, both its parts are near,
    // and the one that most links lead to from the own part is across that crease alone.
    const auto partOf = [&](std::uint32_t i, std::uint32_t cell) -> std::optional<std::uint32_t> {
        const auto near = links.near(i);
        const double reach = voteReach * links.spacing(i);
        std::map<std::uint32_t, double> votes;
        const auto look = [&](std::uint32_t a) {
            for (std::uint32_t e = links.begin(a); cells[a] == cells[i] && e < links.end(a); ++e) {
                const std::uint32_t b = links.link(e).other;
                const double part = base::distance(links.middle(a, e), links.at(i)) / reach;
                if (before[b].cell == cell && part < 1)
                    votes[cells[b]] += (1 - part) * (1 - part);
            }
        };
        look(i);
        std::for_each(near.begin(), near.end(), look);
        const auto most = std::max_element(votes.begin(), votes.end(),
                                           [](const auto& x, const auto& y) { return x.second < y.second; });
        if (most != votes.end())
            return most->first;
        const auto any =
            std::find_if(near.begin(), near.end(), [&](std::uint32_t j) { return before[j].cell == cell; });
        return any == near.end() ? std::nullopt : std::optional(cells[*any]);
    };
    for (std::uint32_t i = 0; i < links.size(); ++i) {
        Label& label = labels[i];
        label.cell = cells[i];
        if (before[i].partner == before[i].cell)
            label.partner = cells[i];
        if (before[i].meeting == Meeting::None)
            continue;
        if (const auto across = partOf(i, before[i].partner))
            label.partner = *across;
    }
}

} // namespace cells
