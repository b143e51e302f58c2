#include "core/cells/creases/cell_refit.h"

#include "core/base/parallel.h"
#include "core/cells/creases/patch_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cells {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double clearly = 0.25, surely = 0.04; ///< spacings by which the patch across is nearer: with noise, without
constexpr std::size_t fewestSure = 6;           ///< members away from corners that a patch is better fitted to alone
constexpr double acrossReach = 2;               ///< spacings: how far off the patch across may begin
constexpr float nearlyOwn = 0.9986f;            ///< cosine of 3 degrees
constexpr double edgeCosine = 0.966;            ///< of 15 degrees: flatter than that both sides still are one surface

} // namespace

CellRefit::CellRefit(SurfelLinks& links, std::span<std::uint32_t> cells, std::span<const std::uint32_t> faces,
                     std::span<const Vec3f> normals, double noise)
    : m_links(links), m_cells(cells), m_normals(normals), m_noise(noise) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        m_faceOf.emplace(cells[i], faces[i]);
    findPairs();
}

void CellRefit::findPairs() {
    for (std::uint32_t i = 0; i < m_links.size(); ++i)
        m_links.forLinks(i, [&](std::uint32_t j, Cut cut) {
            if (cut == Cut::Crease && m_cells[i] < m_cells[j])
                m_pairs.emplace(m_cells[i], m_cells[j]);
        });
}

/// Are there two other cells beside it? Which of the three it is of is least certain.
bool CellRefit::atCorner(std::uint32_t i) const {
    std::uint32_t first = m_cells[i];
    bool out = false;
    m_links.forLinks(i, [&](std::uint32_t j, Cut) {
        if (!parted(m_cells[i], m_cells[j]))
            return;
        if (first == m_cells[i])
            first = m_cells[j];
        out |= m_cells[j] != first;
    });
    return out;
}

std::uint32_t CellRefit::betterCell(std::uint32_t i) const {
    const double s = m_links.spacing(i);
    std::vector<std::uint32_t> others, members;
    for (const std::uint32_t j : m_links.near(i))
        if (parted(m_cells[i], m_cells[j]) && base::distance(m_links.at(i), m_links.at(j)) < acrossReach * s)
            others.push_back(m_cells[j]);
    if (others.empty())
        return m_cells[i];
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    const auto offOf = [&](std::uint32_t cell) {
        members.clear();
        for (const std::uint32_t j : m_links.near(i))
            if (m_cells[j] == cell && !m_atCorner[j])
                members.push_back(j);
        if (members.size() < fewestSure) {
            members.clear();
            for (const std::uint32_t j : m_links.near(i))
                if (m_cells[j] == cell)
                    members.push_back(j);
        }
        const PatchFit fit = fitPatch(m_links, members, m_links.at(i), base::cast<double>(m_normals[i]), s, m_noise);
        return fit.known ? std::abs(fit.height) : std::numeric_limits<double>::infinity();
    };
    std::uint32_t out = m_cells[i];
    // a surfel without any of its cell beside it has lost its way
    bool alone = true;
    m_links.forLinks(i, [&](std::uint32_t j, Cut) { alone &= m_cells[j] != m_cells[i]; });
    double least = alone ? std::numeric_limits<double>::infinity()
                         : offOf(m_cells[i]) - std::min(clearly, surely + 1.2 * m_noise) * s;
    for (const std::uint32_t cell : others)
        if (const double off = offOf(cell); off < least) {
            least = off;
            out = cell;
        }
    return out;
}

void CellRefit::reassign() {
    m_atCorner.resize(m_links.size());
    base::parallelFor(m_atCorner.size(), 1024,
                      [&](std::size_t i) { m_atCorner[i] = atCorner(static_cast<std::uint32_t>(i)) ? 1 : 0; });
    std::vector<std::uint32_t> better(m_links.size());
    base::parallelFor(better.size(), 256,
                      [&](std::size_t i) { better[i] = betterCell(static_cast<std::uint32_t>(i)); });
    std::vector<std::uint32_t> moved;
    for (std::uint32_t i = 0; i < m_links.size(); ++i)
        if (better[i] != m_cells[i]) {
            m_cells[i] = better[i];
            moved.push_back(i);
        }
    for (const std::uint32_t i : moved)
        for (std::uint32_t e = m_links.begin(i); e < m_links.end(i); ++e)
            if (m_links.link(e).cut != Cut::Wall)
                m_links.cut(e, parted(m_cells[i], m_cells[m_links.link(e).other]) ? Cut::Crease : Cut::None);
}

/// Where most of them face. The normal of one alone may be that of the patch across, and at acute edges look away.
Vec3d CellRefit::sideOf(std::span<const std::uint32_t> members) const {
    Vec3d sum;
    for (const std::uint32_t j : members)
        sum += base::cast<double>(m_normals[j]);
    return base::normalized(sum, base::cast<double>(m_normals[members.front()]));
}

std::optional<CellRefit::Sides> CellRefit::sidesAt(std::uint32_t i) const {
    std::vector<std::uint32_t> own{i}, across;
    std::uint32_t other = m_cells[i];
    for (const std::uint32_t j : m_links.near(i)) {
        if (parted(m_cells[i], m_cells[j])) {
            if (other == m_cells[i])
                other = m_cells[j]; // the nearest
            if (m_cells[j] == other)
                across.push_back(j);
        } else if (m_cells[j] == m_cells[i] || faceOf(j) == faceOf(i)) {
            own.push_back(j);
        }
    }
    if (across.empty())
        return std::nullopt;
    const double s = m_links.spacing(i);
    const PatchFit here = fitPatch(m_links, own, m_links.at(i), sideOf(own), s, m_noise);
    if (!here.known)
        return std::nullopt;
    const Vec3d side = sideOf(across);
    const PatchFit there = fitPatch(m_links, across, m_links.at(across.front()), side, s, m_noise);
    return Sides{other, here.normal, there.known ? there.normal : side};
}

void CellRefit::takeBackFlat() {
    std::vector<std::optional<Sides>> sides(m_links.size());
    base::parallelFor(sides.size(), 256, [&](std::size_t i) { sides[i] = sidesAt(static_cast<std::uint32_t>(i)); });
    struct Turn {
        double cosine = 0, count = 0;
    };
    std::map<Pair, Turn> turns;
    for (std::uint32_t i = 0; i < m_links.size(); ++i)
        if (sides[i]) {
            Turn& turn = turns[std::minmax(m_cells[i], sides[i]->other)];
            turn.cosine += dot(sides[i]->here, sides[i]->beyond), ++turn.count;
        }
    for (const auto& [pair, turn] : turns)
        if (m_faceOf.at(pair.first) == m_faceOf.at(pair.second) && turn.cosine > edgeCosine * turn.count)
            m_pairs.erase(pair);
    joinFree();
    for (std::uint32_t i = 0; i < m_links.size(); ++i)
        for (std::uint32_t e = m_links.begin(i); e < m_links.end(i); ++e)
            if (m_links.link(e).cut == Cut::Crease && !parted(m_cells[i], m_cells[m_links.link(e).other]))
                m_links.cut(e, Cut::None);
}

/// What was split for the sake of creases that are no more.
void CellRefit::joinFree() {
    std::set<std::uint32_t> bound;
    for (const auto& [a, b] : m_pairs)
        if (m_faceOf.at(a) == m_faceOf.at(b))
            bound.insert(a), bound.insert(b);
    std::map<std::uint32_t, std::uint32_t> first, becomes;
    for (const auto& [cell, face] : m_faceOf)
        if (!bound.contains(cell))
            becomes[cell] = first.emplace(face, cell).first->second;
    std::set<Pair> pairs;
    const auto now = [&](std::uint32_t cell) {
        const auto found = becomes.find(cell);
        return found == becomes.end() ? cell : found->second;
    };
    for (const auto& [a, b] : m_pairs)
        if (now(a) != now(b))
            pairs.insert(std::minmax(now(a), now(b)));
    m_pairs = std::move(pairs);
    for (std::uint32_t& cell : m_cells)
        cell = now(cell);
}

Vec3f CellRefit::ownNormal(std::uint32_t i) const {
    const Vec3f given = m_links.surfel(i).normal;
    const auto sides = sidesAt(i);
    if (!sides || dot(sides->here, sides->beyond) > edgeCosine ||
        dot(base::cast<float>(sides->here), given) > nearlyOwn)
        return given;
    return base::cast<float>(sides->here);
}

std::vector<Vec3f> CellRefit::ownNormals() const {
    std::vector<Vec3f> out(m_links.size());
    base::parallelFor(out.size(), 256, [&](std::size_t i) { out[i] = ownNormal(static_cast<std::uint32_t>(i)); });
    return out;
}

} // namespace cells
