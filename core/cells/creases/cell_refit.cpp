#include "core/cells/creases/cell_refit.h"

#include "core/base/parallel.h"
#include "core/cells/creases/patch_fit.h"

#include <algorithm>
#include <cmath>

namespace cells {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double clearly = 0.25;      ///< spacings by which the patch across is nearer
constexpr std::size_t fewestSure = 6; ///< members away from corners that a patch is better fitted to alone
constexpr double acrossReach = 2;     ///< spacings: how far off the patch across may begin
constexpr float nearlyOwn = 0.9986f;  ///< cosine of 3 degrees
constexpr double edgeCosine = 0.966;  ///< of 15 degrees: flatter than that both sides still are one surface

} // namespace

CellRefit::CellRefit(SurfelLinks& links, std::span<std::uint32_t> cells, std::span<const std::uint32_t> faces,
                     std::span<const Vec3f> normals, double noise)
    : m_links(links), m_cells(cells), m_faces(faces), m_normals(normals), m_noise(noise) {
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
    double least = alone ? std::numeric_limits<double>::infinity() : offOf(m_cells[i]) - clearly * s;
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

Vec3f CellRefit::ownNormal(std::uint32_t i) const {
    const Vec3f given = m_links.surfel(i).normal;
    std::vector<std::uint32_t> own{i}, across;
    std::uint32_t other = m_cells[i];
    for (const std::uint32_t j : m_links.near(i)) {
        if (parted(m_cells[i], m_cells[j])) {
            if (other == m_cells[i])
                other = m_cells[j]; // the nearest
            if (m_cells[j] == other)
                across.push_back(j);
        } else if (m_cells[j] == m_cells[i] || m_faces[j] == m_faces[i]) {
            own.push_back(j);
        }
    }
    if (across.empty())
        return given;
    const double s = m_links.spacing(i);
    const Vec3d p = m_links.at(i), axis = base::cast<double>(m_normals[i]);
    const PatchFit here = fitPatch(m_links, own, p, axis, s, m_noise);
    if (!here.known)
        return given;
    const Vec3d side = base::cast<double>(m_normals[across.front()]);
    const PatchFit there = fitPatch(m_links, across, m_links.at(across.front()), side, s, m_noise);
    const Vec3d beyond = there.known ? there.normal : side;
    if (dot(here.normal, beyond) > edgeCosine || dot(base::cast<float>(here.normal), given) > nearlyOwn)
        return given;
    return base::cast<float>(here.normal);
}

std::vector<Vec3f> CellRefit::ownNormals() const {
    std::vector<Vec3f> out(m_links.size());
    base::parallelFor(out.size(), 256, [&](std::size_t i) { out[i] = ownNormal(static_cast<std::uint32_t>(i)); });
    return out;
}

} // namespace cells
