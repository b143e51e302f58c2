#include "core/mesh/faces/near_sheets.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/cells/crease_bands.h"
#include "core/mesh/faces/crease_bands.h"
#include "core/mesh/faces/fading_borders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <unordered_map>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double seen = 1.7;                   ///< supports: between them, both may count
constexpr double walked = 1, around = 1.7;     ///< supports, times the distance: what is no longer is no way about
constexpr double aligned = 0.1, oneBend = 0.5; ///< sine and cosine
constexpr double growth = 1.5;                 ///< supports
constexpr double linkable = 4.2;               ///< supports: from edges, where ways are looked for
constexpr float facingAway = -0.3f; ///< cosine: such sheets are told apart by their normals (surface/README 2.7)
constexpr std::uint32_t none = ~0u;
constexpr std::size_t fewestSamples = 4; ///< of a sheet

/// Sheets that face away are told apart by their normals, and of what is one plane or one round bend sums mix nothing.
bool mayMix(const surfel::Surfel& a, const surfel::Surfel& b) {
    const Vec3d n = base::cast<double>(a.normal), m = base::cast<double>(b.normal);
    const Vec3d d = base::normalized(base::cast<double>(b.position) - base::cast<double>(a.position));
    const double cosine = dot(n, m);
    return cosine > facingAway && !(cosine > oneBend && std::abs(dot(n + m, d)) < aligned);
}

} // namespace

NearSheets::NearSheets(const EdgeCrossings& edges, const SampleGrid& grid, std::span<const surfel::Surfel> samples,
                       std::span<const std::uint32_t> faces, std::vector<std::uint32_t> cells, double spacing,
                       double support, std::uint32_t firstNew)
    : m_edges(edges), m_grid(grid), m_samples(samples), m_faces(faces), m_spacing(spacing), m_support(support),
      m_firstNew(firstNew), m_cells(std::move(cells)) {
    findLinks();
    split(strangers());
}

std::vector<bool> NearSheets::samplesNear(const SampleGrid& wide) const {
    std::vector<bool> out(m_samples.size());
    m_edges.forMarks([&](const Vec3d& mark, const FaceEdge& edge) {
        wide.forAround(mark, [&](std::uint32_t a, double) {
            if (m_faces[a] == edge.faces[0] || m_faces[a] == edge.faces[1])
                out[a] = true;
        });
    });
    return out;
}

void NearSheets::findLinks() {
    const std::vector<bool> near = samplesNear(SampleGrid(m_samples, linkable * m_support));
    m_links.resize(m_samples.size());
    base::parallelFor(m_samples.size(), 256, [&](std::size_t i) {
        const auto a = static_cast<std::uint32_t>(i);
        if (!near[a])
            return;
        m_grid.forAround(m_grid.at(a), [&](std::uint32_t b, double) {
            if (b != a && m_faces[b] == m_faces[a] && !throughMatter(m_samples[a], m_samples[b]) &&
                m_edges.crossed(m_faces[a], m_grid.at(a), m_grid.at(b)).times == 0)
                m_links[a].push_back(b);
        });
    });
}

/// Of those given, which no way from a over links leads to: of a walk to the nearest first, until all are found.
std::vector<std::uint32_t> NearSheets::unreached(std::uint32_t a, std::vector<std::uint32_t> others) const {
    using Entry = std::pair<double, std::uint32_t>;
    std::unordered_map<std::uint32_t, double> ways{{a, 0.0}};
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0.0, a);
    const auto limit = [&](std::uint32_t b) {
        return std::max(walked * m_support, around * base::distance(m_grid.at(a), m_grid.at(b)));
    };
    while (!queue.empty() && !others.empty()) {
        const auto [way, at] = queue.top();
        queue.pop();
        if (way > ways.at(at))
            continue;
        if (const auto found = std::lower_bound(others.begin(), others.end(), at);
            found != others.end() && *found == at && way <= limit(at))
            others.erase(found);
        for (const std::uint32_t b : m_links[at]) {
            const double further = way + base::distance(m_grid.at(at), m_grid.at(b));
            if (further > around * seen * m_support)
                continue;
            const auto [known, fresh] = ways.emplace(b, further);
            if (!fresh && known->second <= further)
                continue;
            known->second = further;
            queue.emplace(further, b);
        }
    }
    return others;
}

NearSheets::Strangers NearSheets::strangers() const {
    const SampleGrid wide(m_samples, seen * m_support);
    const std::vector<bool> near = samplesNear(SampleGrid(m_samples, seen / 2 * m_support));
    Strangers out(m_samples.size());
    base::parallelFor(m_samples.size(), 64, [&](std::size_t i) {
        const auto a = static_cast<std::uint32_t>(i);
        if (!near[a])
            return;
        std::vector<std::uint32_t> others;
        wide.forAround(m_grid.at(a), [&](std::uint32_t b, double) {
            if (b != a && m_cells[b] == m_cells[a] && mayMix(m_samples[a], m_samples[b]))
                others.push_back(b);
        });
        std::sort(others.begin(), others.end());
        out[a] = unreached(a, std::move(others));
    });
    for (std::uint32_t a = 0; a < out.size(); ++a) // those farther from the edge are not asked themselves
        for (const std::uint32_t b : std::vector(out[a]))
            if (!near[b])
                out[b].push_back(a);
    return out;
}

/// Each of samples that hang together and of which none are strangers to each other.
std::vector<std::vector<std::uint32_t>> NearSheets::pieces(const Strangers& strangers,
                                                           std::vector<std::uint32_t>& pieceOf) const {
    std::vector<std::vector<std::uint32_t>> out;
    for (std::uint32_t first = 0; first < m_samples.size(); ++first) {
        if (strangers[first].empty() || pieceOf[first] != none)
            continue;
        base::CancelScope::check();
        const auto number = static_cast<std::uint32_t>(out.size());
        std::vector<std::uint32_t>& piece = out.emplace_back();
        using Entry = std::pair<double, std::uint32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        queue.emplace(0.0, first);
        while (!queue.empty()) {
            const auto [way, a] = queue.top();
            queue.pop();
            if (pieceOf[a] != none || std::any_of(strangers[a].begin(), strangers[a].end(),
                                                  [&](std::uint32_t b) { return pieceOf[b] == number; }))
                continue;
            pieceOf[a] = number;
            piece.push_back(a);
            for (const std::uint32_t b : m_links[a])
                if (pieceOf[b] == none && !strangers[b].empty() && m_cells[b] == m_cells[a])
                    queue.emplace(way + base::distance(m_grid.at(a), m_grid.at(b)), b);
        }
    }
    return out;
}

/// Of two pieces that are strangers to each other one becomes a cell of its own, the smaller one where that will do.
void NearSheets::split(const Strangers& strangers) {
    std::vector<std::uint32_t> pieceOf(m_samples.size(), none);
    const std::vector<std::vector<std::uint32_t>> all = pieces(strangers, pieceOf);
    std::vector<std::set<std::uint32_t>> apart(all.size());
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        for (const std::uint32_t b : strangers[a])
            if (pieceOf[b] != none && pieceOf[b] != pieceOf[a])
                apart[pieceOf[a]].insert(pieceOf[b]);
    std::vector<std::uint32_t> order(all.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return all[a].size() > all[b].size(); });
    const std::vector<std::uint32_t> before = m_cells;
    std::vector<std::uint32_t> cellOf(all.size(), none);
    std::uint32_t next = m_firstNew;
    std::vector<std::uint32_t> seeds;
    for (const std::uint32_t p : order) {
        const std::uint32_t own = before[all[p].front()];
        const bool stays =
            std::none_of(apart[p].begin(), apart[p].end(), [&](std::uint32_t other) { return cellOf[other] == own; });
        if (!stays && all[p].size() < fewestSamples)
            continue;
        cellOf[p] = stays ? own : next++;
        for (const std::uint32_t a : all[p]) {
            m_cells[a] = cellOf[p];
            seeds.push_back(a);
        }
    }
    if (next > m_firstNew)
        grow(seeds, before);
}

/// Both sides share what lies around the end of what is between them. Others stay as they were.
void NearSheets::grow(const std::vector<std::uint32_t>& seeds, const std::vector<std::uint32_t>& before) {
    const auto links = [&](std::uint32_t a, const auto& fn) {
        for (const std::uint32_t b : m_links[a])
            fn(b, base::distance(m_grid.at(a), m_grid.at(b)));
    };
    cells::growBands(
        seeds, m_cells, links, [](std::uint32_t, std::uint32_t) { return true; }, growth * m_support);
    for (std::size_t a = 0; a < m_cells.size(); ++a)
        if (!isNew(m_cells[a]))
            m_cells[a] = before[a];
}

template <class Fn>
void NearSheets::forBorderLinks(std::uint32_t a, const Fn& fn) const {
    m_grid.forAround(m_grid.at(a), [&](std::uint32_t b, double) {
        if (m_faces[b] == m_faces[a] && m_cells[b] != m_cells[a] && (isNew(m_cells[a]) || isNew(m_cells[b])) &&
            !throughMatter(m_samples[a], m_samples[b]))
            fn(b);
    });
}

void NearSheets::addBorders(std::vector<cells::CreasePiece>& out) const {
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        forBorderLinks(a, [&](std::uint32_t b) {
            if (b < a || m_edges.crossed(m_faces[a], m_grid.at(a), m_grid.at(b)).times > 0)
                return;
            const Vec3d way = m_grid.at(b) - m_grid.at(a), middle = m_grid.at(a) + way / 2;
            const bool convex = dot(base::cast<double>(m_samples[a].normal - m_samples[b].normal), way) < 0;
            out.push_back(
                {middle, middle, m_cells[a], m_cells[b], convex ? cells::Meeting::Convex : cells::Meeting::Concave});
        });
}

void NearSheets::fade(std::span<cells::Label> labels) const {
    std::vector<BorderLink> links;
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        forBorderLinks(a, [&](std::uint32_t b) {
            if (b > a)
                links.push_back({(m_grid.at(a) + m_grid.at(b)) / 2, std::minmax(m_cells[a], m_cells[b]),
                                 m_edges.crossed(m_faces[a], m_grid.at(a), m_grid.at(b)).times > 0});
        });
    const FadingBorders borders(links, m_support);
    std::map<std::uint32_t, std::uint32_t> faces; // of new cells
    for (std::uint32_t a = 0; a < m_samples.size(); ++a)
        faces[m_cells[a]] = m_faces[a];
    base::parallelFor(m_samples.size(), 256, [&](std::size_t i) {
        cells::Label& label = labels[i];
        if (label.meeting == cells::Meeting::None || !(isNew(label.cell) || isNew(label.partner)))
            return;
        const auto other = faces.find(label.partner);
        if (other != faces.end() && other->second == m_faces[i])
            label.sharpness = borders.sharpness(label.cell, label.partner, m_grid.at(static_cast<std::uint32_t>(i)));
    });
}

} // namespace mesh
