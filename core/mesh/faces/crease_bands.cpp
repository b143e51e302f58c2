#include "core/mesh/faces/crease_bands.h"

#include "core/cells/crease_bands.h"
#include "core/cells/crease_labels.h"
#include "core/surface/evaluation/weights.h"

#include <algorithm>
#include <array>
#include <map>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double crossingReach = 1.2;           ///< spacings from the middle of a link to the edge that it crosses
constexpr double markDistance = 0.5;            ///< spacings between marks on edges
constexpr double bandWidth = 3;                 ///< supports
constexpr double opposed = -0.5, upright = 0.8; ///< cosines: links from one side of a wall to the other
constexpr double sharpnessReach = 0.8;          ///< supports: links whose share tells how sharp the crease is
constexpr double leastShare = 0.15, shareRange = 0.6;

struct Foot {
    double along = 0; ///< 0 to 1 on the edge
    double distanceSq = 0;
};
Foot footOn(const SharpEdge& edge, const Vec3d& p) {
    const Vec3d way = edge.to - edge.from;
    Foot out;
    out.along = lengthSq(way) > 0 ? dot(p - edge.from, way) / lengthSq(way) : 0;
    out.distanceSq = base::distanceSq(p, edge.from + way * std::clamp(out.along, 0.0, 1.0));
    return out;
}

} // namespace

double sideOf(const FaceTopology& topology, const SharpEdge& edge, const Vec3d& p) {
    const Vec3d way = edge.to - edge.from;
    const Vec3d y = edge.from + way * std::clamp(footOn(edge, p).along, 0.0, 1.0);
    const double side = dot(p - y, topology.normals[edge.left] - topology.normals[edge.right]);
    return edge.convex ? side : -side;
}

CreaseBands::CreaseBands(const FaceTopology& topology, const SampleGrid& grid, std::span<const surfel::Surfel> samples,
                         std::span<const std::uint32_t> faces, std::span<const SharpEdge> edges,
                         std::span<const std::uint32_t> edgeFaces, double spacing, double support,
                         std::uint32_t firstBand)
    : m_topology(topology), m_grid(grid), m_samples(samples), m_faces(faces), m_edges(edges), m_edgeFaces(edgeFaces),
      m_spacing(spacing), m_support(support), m_firstBand(firstBand), m_cells(faces.begin(), faces.end()) {
    if (edges.empty())
        return;
    findTips();
    findMarks();
    split();
}

void CreaseBands::findTips() {
    using Place = std::array<double, 4>; // with the face
    std::map<Place, int> ends;
    const auto place = [&](const Vec3d& p, std::size_t i) {
        return Place{p.x, p.y, p.z, static_cast<double>(m_edgeFaces[i])};
    };
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
        ++ends[place(m_edges[i].from, i)];
        ++ends[place(m_edges[i].to, i)];
    }
    m_tips.resize(m_edges.size());
    for (std::size_t i = 0; i < m_edges.size(); ++i)
        m_tips[i] = static_cast<std::uint8_t>((ends[place(m_edges[i].from, i)] == 1 ? 1 : 0) |
                                              (ends[place(m_edges[i].to, i)] == 1 ? 2 : 0));
}

void CreaseBands::findMarks() {
    m_near.assign(m_samples.size(), false);
    const double side = (crossingReach + markDistance) * m_spacing;
    for (std::uint32_t i = 0; i < m_edges.size(); ++i) {
        const Vec3d way = m_edges[i].to - m_edges[i].from;
        const auto marks = static_cast<std::size_t>(std::ceil(length(way) / (markDistance * m_spacing))) + 1;
        for (std::size_t k = 0; k <= marks; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(marks);
            const Vec3d mark = m_edges[i].from + way * share;
            m_grid.forAround(mark, [&](std::uint32_t a, double) {
                if (m_faces[a] == m_edgeFaces[i])
                    m_near[a] = true;
            });
            std::vector<std::uint32_t>& there = m_marks.at(base::cellOf(mark, Vec3d(), 1 / side));
            if (there.empty() || there.back() != i)
                there.push_back(i);
        }
    }
}

const SharpEdge* CreaseBands::crossed(std::uint32_t a, std::uint32_t b) const {
    if (!m_near[a] && !m_near[b])
        return nullptr;
    const double side = (crossingReach + markDistance) * m_spacing, reach = crossingReach * m_spacing;
    const Vec3d middle = (m_grid.at(a) + m_grid.at(b)) / 2;
    double least = reach * reach;
    std::uint32_t nearest = 0;
    bool found = false;
    base::forCellsAround(base::cellOf(middle, Vec3d(), 1 / side), [&](const base::Cell& around) {
        if (const std::vector<std::uint32_t>* there = m_marks.find(around))
            for (const std::uint32_t e : *there) {
                if (m_edgeFaces[e] != m_faces[a])
                    continue;
                const double distanceSq = footOn(m_edges[e], middle).distanceSq;
                if (distanceSq < least || (found && distanceSq == least && e < nearest)) {
                    least = distanceSq;
                    nearest = e;
                    found = true;
                }
            }
    });
    if (!found)
        return nullptr;
    const SharpEdge& edge = m_edges[nearest];
    const double along = footOn(edge, middle).along;
    if ((along < 0 && (m_tips[nearest] & 1u) != 0) || (along > 1 && (m_tips[nearest] & 2u) != 0))
        return nullptr; // round the end
    const bool leftA = sideOf(m_topology, edge, m_grid.at(a)) > 0, leftB = sideOf(m_topology, edge, m_grid.at(b)) > 0;
    return leftA != leftB ? &edge : nullptr;
}

bool CreaseBands::throughMatter(std::uint32_t a, std::uint32_t b) const {
    const Vec3d n = base::cast<double>(m_samples[a].normal), m = base::cast<double>(m_samples[b].normal);
    const Vec3d d = base::normalized(m_grid.at(b) - m_grid.at(a));
    return dot(n, m) < opposed && std::abs(dot(n, d)) > upright && std::abs(dot(m, d)) > upright;
}

template <class Fn>
void CreaseBands::forLinks(std::uint32_t a, const Fn& fn) const {
    m_grid.forAround(m_grid.at(a), [&](std::uint32_t b, double) {
        if (b != a && m_faces[b] == m_faces[a] && !throughMatter(a, b))
            fn(b);
    });
}

void CreaseBands::split() {
    std::vector<cells::BandPairs::Link> crossing;
    std::vector<double> convex;
    std::vector<bool> isEnd(m_samples.size());
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        if (m_near[a])
            forLinks(a, [&](std::uint32_t b) {
                const SharpEdge* edge = b > a || !m_near[b] ? crossed(a, b) : nullptr;
                if (!edge)
                    return;
                crossing.emplace_back(a, b);
                convex.push_back(edge->convex ? 1 : -1);
                isEnd[a] = isEnd[b] = true;
            });
    std::vector<cells::FlatLink> flat;
    std::vector<std::uint32_t> ends;
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        if (isEnd[a]) {
            ends.push_back(a);
            forLinks(a, [&](std::uint32_t b) {
                if (b > a && isEnd[b] && !crossed(a, b))
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
    const auto open = [&](std::uint32_t a, std::uint32_t b) { return !crossed(a, b); };
    cells::growBands(seeds, m_cells, links, open, bandWidth * m_support);
}

void CreaseBands::fade(std::span<cells::Label> labels) const {
    if (m_convex.empty())
        return;
    struct Crossing {
        Vec3d middle;
        std::uint32_t pair;
        bool cut;
    };
    const double reach = sharpnessReach * m_support;
    base::CellMap<std::vector<Crossing>> links; // between bands of one pair
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        if (m_cells[a] >= m_firstBand)
            forLinks(a, [&](std::uint32_t b) {
                if (b < a || m_cells[b] != across(m_cells[a]))
                    return;
                const Vec3d middle = (m_grid.at(a) + m_grid.at(b)) / 2;
                links.at(base::cellOf(middle, Vec3d(), 1 / reach))
                    .push_back({middle, (m_cells[a] - m_firstBand) / 2, crossed(a, b) != nullptr});
            });
    const double partner = cells::partnerReach * m_spacing;
    for (std::uint32_t a = 0; a < m_samples.size(); ++a) {
        if (m_cells[a] < m_firstBand)
            continue;
        const std::uint32_t other = across(m_cells[a]), pair = (m_cells[a] - m_firstBand) / 2;
        cells::Label& label = labels[a];
        if (label.meeting == cells::Meeting::None) { // beyond the end of the crease both sides still know each other
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
        double cut = 0, all = 0;
        base::forCellsAround(base::cellOf(m_grid.at(a), Vec3d(), 1 / reach), [&](const base::Cell& around) {
            if (const std::vector<Crossing>* there = links.find(around))
                for (const Crossing& each : *there) {
                    const double distance = base::distance(each.middle, m_grid.at(a));
                    if (each.pair != pair || !(distance < reach))
                        continue;
                    const auto weight = static_cast<double>(surface::wendlandC2(static_cast<float>(distance / reach)));
                    all += weight;
                    cut += each.cut ? weight : 0;
                }
        });
        const double share = all > 0 ? cut / all : 0;
        label.sharpness =
            static_cast<std::uint8_t>(std::lround(255 * std::clamp((share - leastShare) / shareRange, 0.0, 1.0)));
    }
}

} // namespace mesh
