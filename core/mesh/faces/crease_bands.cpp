#include "core/mesh/faces/crease_bands.h"

#include "core/cells/crease_bands.h"
#include "core/cells/crease_labels.h"
#include "core/mesh/faces/fading_borders.h"

#include <algorithm>
#include <map>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double bandWidth = 3;                 ///< supports
constexpr double opposed = -0.5, upright = 0.8; ///< cosines: links from one side of a wall to the other

} // namespace

bool throughMatter(const surfel::Surfel& a, const surfel::Surfel& b) {
    const Vec3d n = base::cast<double>(a.normal), m = base::cast<double>(b.normal);
    const Vec3d d = base::normalized(base::cast<double>(b.position) - base::cast<double>(a.position));
    return dot(n, m) < opposed && std::abs(dot(n, d)) > upright && std::abs(dot(m, d)) > upright;
}

CreaseBands::CreaseBands(const EdgeCrossings& edges, const SampleGrid& grid, std::span<const surfel::Surfel> samples,
                         std::span<const std::uint32_t> faces, double spacing, double support, std::uint32_t firstBand)
    : m_edges(edges), m_grid(grid), m_samples(samples), m_faces(faces), m_spacing(spacing), m_support(support),
      m_firstBand(firstBand), m_cells(faces.begin(), faces.end()) {
    split();
}

template <class Fn>
void CreaseBands::forLinks(std::uint32_t a, const Fn& fn) const {
    m_grid.forAround(m_grid.at(a), [&](std::uint32_t b, double) {
        if (b != a && m_faces[b] == m_faces[a] && !throughMatter(m_samples[a], m_samples[b]))
            fn(b);
    });
}

void CreaseBands::split() {
    std::vector<bool> near(m_samples.size()); // one of them is at an end of every link that crosses
    bool any = false;
    m_edges.forMarks([&](const Vec3d& mark, const FaceEdge& edge) {
        if (edge.faces[0] != edge.faces[1])
            return;
        any = true;
        m_grid.forAround(mark, [&](std::uint32_t a, double) {
            if (m_faces[a] == edge.faces[0])
                near[a] = true;
        });
    });
    if (!any)
        return;
    std::vector<cells::BandPairs::Link> crossing;
    std::vector<double> convex;
    std::vector<bool> isEnd(m_samples.size());
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        if (near[a])
            forLinks(a, [&](std::uint32_t b) {
                if (b < a && near[b])
                    return;
                const auto [times, edge] = crossed(a, b);
                if (times != 1 || edge->faces[0] != edge->faces[1])
                    return;
                crossing.emplace_back(a, b);
                convex.push_back(edge->edge.convex ? 1 : -1);
                isEnd[a] = isEnd[b] = true;
            });
    std::vector<cells::FlatLink> flat;
    std::vector<std::uint32_t> ends;
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        if (isEnd[a]) {
            ends.push_back(a);
            forLinks(a, [&](std::uint32_t b) {
                if (b > a && isEnd[b] && crossed(a, b).times == 0)
                    flat.push_back({1 - dot(m_samples[a].normal, m_samples[b].normal), a, b});
            });
        }
    cells::BandPairs pairs(m_samples.size(), crossing, std::move(flat), ends);
    m_convex.assign(pairs.count(), 0);
    for (std::size_t i = 0; i < crossing.size(); ++i)
        if (const auto band = pairs.bandOf(crossing[i].first))
            m_convex[*band / 2] += convex[i];
    std::vector<std::uint32_t> seeds;
    for (const std::uint32_t a : ends)
        if (const auto band = pairs.bandOf(a)) {
            m_cells[a] = m_firstBand + *band;
            seeds.push_back(a);
        }
    const auto links = [&](std::uint32_t a, const auto& fn) {
        forLinks(a, [&](std::uint32_t b) { fn(b, base::distance(m_grid.at(a), m_grid.at(b))); });
    };
    const auto open = [&](std::uint32_t a, std::uint32_t b) { return crossed(a, b).times == 0; };
    cells::growBands(seeds, m_cells, links, open, bandWidth * m_support);
}

void CreaseBands::fade(std::span<cells::Label> labels) const {
    if (m_convex.empty())
        return;
    std::vector<BorderLink> links; // between bands of one pair
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        if (m_cells[a] >= m_firstBand)
            forLinks(a, [&](std::uint32_t b) {
                if (b > a && m_cells[b] == across(m_cells[a]))
                    links.push_back({(m_grid.at(a) + m_grid.at(b)) / 2, std::minmax(m_cells[a], m_cells[b]),
                                     crossed(a, b).times > 0});
            });
    const FadingBorders borders(links, m_support);
    const double partner = cells::partnerReach * m_spacing;
    for (std::uint32_t a = 0; a < m_samples.size(); ++a) {
        if (m_cells[a] < m_firstBand)
            continue;
        const std::uint32_t other = across(m_cells[a]), pair = (m_cells[a] - m_firstBand) / 2;
        cells::Label& label = labels[a];
        if (label.meeting == cells::Meeting::None &&
            label.cell == m_cells[a]) { // beyond the end of the crease both sides still know each other
            bool near = false;
            m_grid.forAround(m_grid.at(a), [&](std::uint32_t b, double distanceSq) {
                near |= m_cells[b] == other && distanceSq < partner * partner;
            });
            if (!near)
                continue;
            label.partner = other;
            label.meeting = m_convex[pair] < 0 ? cells::Meeting::Concave : cells::Meeting::Convex;
        }
        if (label.partner != other)
            continue;
        label.sharpness = borders.sharpness(m_cells[a], other, m_grid.at(a));
    }
}

} // namespace mesh
