#include "core/mesh/complexes/rim_chains.h"

#include "core/complexes/foot_on_cell.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double same = 0.35; ///< in cells of the patches: what is nearer along the curve is one vertex

struct Cut {
    double way = 0;
    std::uint32_t patch = 0, vertex = 0;
};

} // namespace

RimChains::RimChains(const complexes::Complex& complex, const std::vector<PatchMesh>& patches)
    : m_complex(complex), m_of(patches.size()) {
    for (std::uint32_t c = 0; c < complex.cells().size(); ++c)
        if (complex[c].dimension == 0) {
            m_points[c] = static_cast<std::uint32_t>(m_vertices.size());
            m_vertices.push_back(complex.place(c));
        }
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> cuts(complex.cells().size());
    for (std::uint32_t p = 0; p < patches.size(); ++p)
        for (std::uint32_t v = 0; v < patches[p].on.size(); ++v) {
            const std::uint32_t on = patches[p].on[v];
            if (on == PatchMesh::inside)
                continue;
            if (complex[on].dimension == 0)
                m_of[p][v] = m_points.at(on);
            else
                cuts[on].emplace_back(p, v);
        }
    for (std::uint32_t c = 0; c < complex.cells().size(); ++c)
        if (complex[c].dimension == 1)
            addCurve(patches, c, cuts[c]);
}

void RimChains::addCurve(const std::vector<PatchMesh>& patches, std::uint32_t curve,
                         const std::vector<std::pair<std::uint32_t, std::uint32_t>>& vertices) {
    const complexes::Complex& complex = m_complex;
    const complexes::TracedCurve traced = trace(complex, curve);
    std::vector<Cut> cuts;
    double cell = std::numeric_limits<double>::infinity();
    for (const auto& [p, v] : vertices) {
        cuts.push_back({traced.wayOf(patches[p].mesh.positions[v]), p, v});
        cell = std::min(cell, patches[p].cell);
    }
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
        return a.way != b.way ? a.way < b.way : a.patch != b.patch ? a.patch < b.patch : a.vertex < b.vertex;
    });
    Chain chain;
    chain.closed = traced.closed;
    const auto& ends = complex[curve].boundary;
    if (!ends.empty())
        chain.vertices.push_back(m_points.at(ends.front()));
    const double length = traced.length(), near = same * cell;
    for (std::size_t i = 0; i < cuts.size();) {
        std::size_t last = i;
        while (last + 1 < cuts.size() && cuts[last + 1].way - cuts[i].way < near)
            ++last;
        double way = 0;
        for (std::size_t k = i; k <= last; ++k)
            way += cuts[k].way / static_cast<double>(last - i + 1);
        const bool atBegin = way < near, atEnd = length - way < near;
        std::uint32_t vertex = 0;
        if (!ends.empty() && (atBegin || atEnd)) {
            vertex = m_points.at(atBegin ? ends.front() : ends.back());
        } else if (ends.empty() && atEnd && !chain.vertices.empty()) {
            vertex = chain.vertices.front(); // round and back
        } else {
            vertex = static_cast<std::uint32_t>(m_vertices.size());
            const complexes::CellFoot foot = footOn(complex, curve, traced.at(way), {});
            m_vertices.push_back(foot.ok() ? foot.position : traced.at(way));
            chain.vertices.push_back(vertex);
        }
        for (std::size_t k = i; k <= last; ++k)
            m_of[cuts[k].patch][cuts[k].vertex] = vertex;
        i = last + 1;
    }
    if (!ends.empty())
        chain.vertices.push_back(m_points.at(ends.back()));
    else if (!chain.vertices.empty())
        chain.vertices.push_back(chain.vertices.front());
    m_chains.emplace(curve, std::move(chain));
}

RimChains::Places RimChains::placesIn(const Chain& chain, std::uint32_t v) const {
    Places out;
    for (std::size_t i = 0; i < chain.vertices.size(); ++i)
        if (chain.vertices[i] == v)
            out.push_back(i);
    return out;
}

/// The shorter way along one curve.
std::vector<std::uint32_t> RimChains::along(const Chain& chain, std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    const std::size_t around = chain.closed && chain.vertices.size() > 1 ? chain.vertices.size() - 1 : 0;
    const auto consider = [&](std::size_t from, std::size_t steps, bool forwards) {
        if (steps == 0 || steps - 1 >= least)
            return;
        least = steps - 1;
        best.clear();
        for (std::size_t k = 1; k < steps; ++k) {
            const std::size_t n = around > 0 ? around : chain.vertices.size();
            best.push_back(chain.vertices[forwards ? (from + k) % n : (from + n * steps - k) % n]);
        }
    };
    for (const std::size_t from : placesIn(chain, a))
        for (const std::size_t to : placesIn(chain, b)) {
            consider(from, to > from ? to - from : from - to, to > from);
            if (around > 0)
                consider(from, around - (to > from ? to - from : from - to), to < from);
        }
    return best;
}

std::vector<std::uint32_t> RimChains::between(std::uint32_t patch, std::uint32_t a, std::uint32_t b) const {
    const auto on = [&](const Chain& chain, std::uint32_t v) { return !placesIn(chain, v).empty(); };
    const std::vector<std::uint32_t>& curves = m_complex[patch].boundary;
    for (const std::uint32_t c : curves)
        if (const Chain& chain = m_chains.at(c); on(chain, a) && on(chain, b))
            return along(chain, a, b);
    // around a corner
    std::vector<std::uint32_t> best;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::uint32_t first : curves)
        for (const std::uint32_t second : curves) {
            const Chain &from = m_chains.at(first), &to = m_chains.at(second);
            if (first == second || !on(from, a) || !on(to, b))
                continue;
            for (const std::uint32_t cell : m_complex[patch].sharedEnds) {
                const std::uint32_t corner = m_points.at(cell);
                if (!on(from, corner) || !on(to, corner))
                    continue;
                std::vector<std::uint32_t> way = along(from, a, corner);
                way.push_back(corner);
                const std::vector<std::uint32_t> rest = along(to, corner, b);
                way.insert(way.end(), rest.begin(), rest.end());
                if (way.size() < least) {
                    least = way.size();
                    best = std::move(way);
                }
            }
        }
    return best;
}

} // namespace mesh
