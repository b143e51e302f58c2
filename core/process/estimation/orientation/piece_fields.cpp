#include "core/process/estimation/orientation/piece_fields.h"

#include "core/base/parallel.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/winding/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

/// Points at which fields are asked for, of all pieces together, times pieces that are asked for theirs.
constexpr std::size_t mostAsked = 100000;
constexpr std::size_t mostLookedAt = 4000;
/// Of what the others say without their signs, below which they say nothing: closed bodies have no field outside.
constexpr double saysNothing = 0.05;

/// Signs of pieces, and what they say to each other.
class Pieces {
  public:
    explicit Pieces(std::vector<double> fits, std::size_t count)
        : m_fits(std::move(fits)), m_field(count), m_loudness(count), m_sign(count, 0), m_group(count, 0) {}

    /// From the first piece on, each time the one about which the others have most to say; one about which they say
    /// next to nothing begins a group of its own. Then pieces turn over one by one as long as that makes the whole
    /// agree better.
    void solve(const base::Progress& progress) {
        std::size_t group = 0;
        add(0, 1);
        for (std::size_t placed = 1; placed < m_sign.size(); ++placed) {
            progress.step(static_cast<double>(placed) / static_cast<double>(m_sign.size()), "Orienting normals");
            std::size_t best = m_sign.size();
            for (std::size_t p = 0; p < m_sign.size(); ++p)
                if (m_sign[p] == 0 && (best == m_sign.size() || std::abs(m_field[p]) > std::abs(m_field[best])))
                    best = p;
            group += std::abs(m_field[best]) <= saysNothing * m_loudness[best] ? 1u : 0u;
            m_group[best] = group;
            add(best, m_field[best] < 0 ? -1 : 1);
        }
        for (std::size_t turns = 0; turns < 4 * m_sign.size(); ++turns) { // each adds to the agreement
            std::size_t worst = 0;
            for (std::size_t p = 1; p < m_sign.size(); ++p)
                if (m_sign[p] * m_field[p] < m_sign[worst] * m_field[worst])
                    worst = p;
            if (m_sign[worst] * m_field[worst] >= 0)
                break;
            add(worst, -2 * m_sign[worst]);
        }
    }
    bool turned(std::size_t piece) const { return m_sign[piece] < 0; }
    std::size_t group(std::size_t piece) const { return m_group[piece]; }

  private:
    void add(std::size_t piece, int sign) {
        for (std::size_t p = 0; p < m_sign.size(); ++p) {
            m_field[p] += sign * m_fits[p * m_sign.size() + piece];
            m_loudness[p] += m_sign[piece] == 0 ? std::abs(m_fits[p * m_sign.size() + piece]) : 0;
        }
        m_sign[piece] += sign;
    }

    std::vector<double> m_fits; ///< symmetric, nothing for a piece itself
    std::vector<double> m_field, m_loudness;
    std::vector<int> m_sign;
    std::vector<std::size_t> m_group;
};

/// The area that a point stands for, by its nearest neighbours, times its normal as the trees turn it.
Vec3f areaOf(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals, base::ParitySets& trees,
             std::uint32_t i) {
    const NeighbourTable::Row row = links.row(i);
    std::array<float, ringSize> distancesSq;
    const std::size_t count = std::min(ringSize, links.count());
    for (std::size_t k = 0; k < count; ++k)
        distancesSq[k] = base::distanceSq(cloud.positions()[i], cloud.positions()[row[k]]);
    const float spacing = spacingOfRing(std::span(distancesSq).first(count));
    return normals[i] * (trees.find(i).opposite ? -spacing * spacing : spacing * spacing);
}

/// Above zero where the signs of two pieces fit the surface of a body: both on one flat sheet, or on its two sides.
std::vector<double> fitsBetween(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals,
                                const std::vector<std::vector<std::uint32_t>>& pieces, base::ParitySets& trees,
                                const base::Progress& progress) {
    const std::size_t count = pieces.size();
    std::vector<surface::WindingNumber> fields;
    std::vector<std::vector<Vec3f>> areas(count);
    for (std::size_t p = 0; p < count; ++p) {
        progress.step(0.5 * static_cast<double>(p) / static_cast<double>(count), "Orienting normals");
        std::vector<Vec3f> places;
        for (const std::uint32_t i : pieces[p]) {
            places.push_back(cloud.positions()[i]);
            areas[p].push_back(areaOf(cloud, links, normals, trees, i));
        }
        fields.emplace_back(places, areas[p]);
    }
    const std::size_t step = 1 + cloud.size() * count / mostAsked;
    std::vector<double> oneWay(count * count);
    base::parallelFor(count * count, 1, [&](std::size_t pair) {
        const std::size_t p = pair / count, q = pair % count;
        for (std::size_t k = step / 2 % pieces[p].size(); k < pieces[p].size() && p != q; k += step) {
            const Vec3d field = fields[q].gradient(base::cast<double>(cloud.positions()[pieces[p][k]]));
            oneWay[pair] -= static_cast<double>(step) * dot(base::cast<double>(areas[p][k]), field);
        }
    });
    std::vector<double> fits(count * count);
    for (std::size_t p = 0; p < count; ++p)
        for (std::size_t q = 0; q < count; ++q)
            fits[p * count + q] = oneWay[p * count + q] + oneWay[q * count + p];
    return fits;
}

} // namespace

std::vector<SignRelation> relationsOfPieces(const Cloud& cloud, const NeighbourTable& links,
                                            std::span<const Vec3f> normals,
                                            const std::vector<std::vector<std::uint32_t>>& pieces,
                                            base::ParitySets& trees, const base::Progress& progress) {
    if (pieces.size() < 2)
        return {};
    Pieces judged(fitsBetween(cloud, links, normals, pieces, trees, part(progress, 0, 0.8)), pieces.size());
    judged.solve(part(progress, 0.8, 1));
    std::vector<SignRelation> out;
    std::vector<std::size_t> first(pieces.size(), pieces.size()); // piece of each group
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        std::size_t& with = first[judged.group(p)];
        if (with < pieces.size()) {
            const std::uint32_t a = pieces[with].front(), b = pieces[p].front();
            const bool alike = trees.find(a).opposite == trees.find(b).opposite;
            out.push_back({a, b, alike == (judged.turned(with) != judged.turned(p))});
        } else {
            with = p;
        }
    }
    return out;
}

double farFromBodies(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals,
                     base::ParitySets& signs) {
    std::vector<Vec3f> areas(cloud.size());
    for (std::uint32_t i = 0; i < areas.size(); ++i)
        areas[i] = areaOf(cloud, links, normals, signs, i);
    const surface::WindingNumber winding(cloud.positions(), areas);
    const std::size_t step = 1 + areas.size() / mostLookedAt, count = (areas.size() + step - 1) / step;
    std::vector<double> off(count);
    base::parallelFor(count, 16, [&](std::size_t k) {
        const std::size_t i = k * step;
        const Vec3d x = base::cast<double>(cloud.positions()[i]), n = base::cast<double>(normals[i]);
        const double above = 2 * std::sqrt(static_cast<double>(length(areas[i])));
        for (const double height : {above, -above}) {
            const double w = winding.at(x + n * height);
            off[k] += std::abs(w - std::round(w)) / 2;
        }
    });
    return std::accumulate(off.begin(), off.end(), 0.0) / static_cast<double>(count);
}

} // namespace process
