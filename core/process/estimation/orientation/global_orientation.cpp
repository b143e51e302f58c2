#include "core/process/estimation/orientation/global_orientation.h"

#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/orientation/orientation_pieces.h"
#include "core/process/estimation/orientation/orientation_trees.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

constexpr const char* orienting = "Orienting normals";
/// Groups of points that count as one dipole, about so many.
constexpr std::size_t mostDipoles = 4000;
constexpr double doubtfulShare = 0.25;

struct Dipole {
    Vec3d place, moment; ///< area times normal
    double softSq = 0;   ///< its area: within it there is no field to speak of
    std::uint32_t piece = 0;
};

/// What one dipole's field gives to another that looks along it: above zero where their signs fit the surface of a
/// body, both on one flat sheet or on its two sides.
double fit(const Dipole& a, const Dipole& b) {
    const Vec3d r = a.place - b.place;
    const double square = lengthSq(r) + a.softSq + b.softSq, cube = square * std::sqrt(square);
    return (dot(a.moment, b.moment) - 3 * dot(a.moment, r) * dot(b.moment, r) / square) / cube;
}

/// Signs of pieces, and what they say to each other.
class Pieces {
  public:
    /// `members` of each piece in the order of the curve, `normals` with the signs that hold within a piece.
    Pieces(std::vector<Dipole> dipoles, std::size_t count, const base::Progress& progress)
        : m_fits(count * count), m_field(count), m_sign(count, 0) {
        std::vector<std::size_t> first(count + 1);
        for (const Dipole& d : dipoles)
            ++first[d.piece + 1];
        for (std::size_t p = 0; p < count; ++p)
            first[p + 1] += first[p];
        progress.step(0, orienting);
        base::parallelFor(count, 4, [&](std::size_t p) {
            for (std::size_t i = first[p]; i < first[p + 1]; ++i)
                for (const Dipole& other : dipoles)
                    if (other.piece != p)
                        m_fits[p * count + other.piece] += fit(dipoles[i], other);
        });
    }

    /// Signs, +1 or -1: from the first piece on, each time the piece about which the others have most to say; then
    /// turned one by one as long as that makes the whole agree better.
    const std::vector<int>& solve(const base::Progress& progress) {
        place(0, 1);
        for (std::size_t placed = 1; placed < m_sign.size(); ++placed) {
            progress.step(0.5 * static_cast<double>(placed) / static_cast<double>(m_sign.size()), orienting);
            std::size_t best = m_sign.size();
            for (std::size_t p = 0; p < m_sign.size(); ++p)
                if (m_sign[p] == 0 && (best == m_sign.size() || std::abs(m_field[p]) > std::abs(m_field[best])))
                    best = p;
            place(best, m_field[best] < 0 ? -1 : 1);
        }
        for (std::size_t turns = 0; turns < 4 * m_sign.size(); ++turns) { // each adds to the agreement
            progress.step(0.5, orienting);
            std::size_t worst = 0;
            for (std::size_t p = 1; p < m_sign.size(); ++p)
                if (m_sign[p] * m_field[p] < m_sign[worst] * m_field[worst])
                    worst = p;
            if (m_sign[worst] * m_field[worst] >= 0)
                break;
            const int sign = m_sign[worst];
            place(worst, -2 * sign);
            m_sign[worst] = -sign;
        }
        return m_sign;
    }

  private:
    void place(std::size_t piece, int sign) {
        for (std::size_t p = 0; p < m_sign.size(); ++p)
            m_field[p] += sign * m_fits[p * m_sign.size() + piece];
        m_sign[piece] = sign;
    }

    std::vector<double> m_fits; ///< symmetric, nothing for a piece itself
    std::vector<double> m_field;
    std::vector<int> m_sign;
};

/// Runs along the curve are compact: some points in a row make a dipole.
std::vector<Dipole> dipolesOf(const std::vector<std::vector<std::uint32_t>>& pieces, base::ParitySets& trees,
                              const Cloud& cloud, std::span<const Vec3f> normals, std::span<const float> spacing) {
    const std::size_t run = std::max<std::size_t>(4, cloud.size() / mostDipoles);
    std::vector<Dipole> out;
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
        for (std::size_t from = 0; from < pieces[p].size(); from += run) {
            Dipole d;
            d.piece = p;
            for (std::size_t k = from; k < std::min(from + run, pieces[p].size()); ++k) {
                const std::uint32_t i = pieces[p][k];
                const double area = static_cast<double>(spacing[i]) * static_cast<double>(spacing[i]);
                d.moment += base::cast<double>(normals[i]) * (trees.find(i).opposite ? -area : area);
                d.place += base::cast<double>(cloud.positions()[i]) * area;
                d.softSq += area;
            }
            if (d.softSq > 0) {
                d.place = d.place / d.softSq;
                out.push_back(d);
            }
        }
    return out;
}

} // namespace

bool orientGlobally(const Cloud& cloud, const NeighbourTable& links, std::span<Vec3f> normals,
                    const base::Progress& progress, Sides given) {
    if (cloud.size() < 2)
        return true;
    OrientationTrees trees(cloud, links, normals, part(progress, 0, 0.4));
    const std::vector<float> spacing = spacingsOf(cloud, part(progress, 0.4, 0.6));
    base::ParitySets& signs = trees.signs();
    trees.joinBelow(pieceUnlike, part(progress, 0.6, 0.65));
    const std::vector<std::vector<std::uint32_t>> pieces = largePieces(signs, cloud.size());
    if (pieces.size() > 1) {
        Pieces judged(dipolesOf(pieces, signs, cloud, normals, spacing), pieces.size(), part(progress, 0.65, 0.8));
        const std::vector<int>& sign = judged.solve(part(progress, 0.8, 0.85));
        std::vector<std::uint8_t> turned; // told from roots, before these change
        for (std::size_t p = 0; p < pieces.size(); ++p)
            turned.push_back(signs.find(pieces[p].front()).opposite != (sign[p] < 0));
        for (std::size_t p = 1; p < pieces.size(); ++p)
            signs.relate(pieces[0].front(), pieces[p].front(), turned[0] != turned[p]);
    }
    trees.joinAll(part(progress, 0.85, 0.9));
    const bool sided = !trees.hasSeam(part(progress, 0.9, 0.95));
    trees.takeSigns(given, part(progress, 0.95, 1));
    return sided;
}

std::vector<std::uint8_t> doubtfulSigns(const Cloud& cloud, const NeighbourTable& links, std::span<const Vec3f> normals,
                                        const base::Progress& progress) {
    std::vector<std::uint8_t> out(cloud.size());
    const NormalLinks edges(cloud.positions(), links, normals);
    progress.step(0, "Judging the orientation");
    base::parallelChunks(edges.size(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
        edges.forRows(begin, end, [&](std::uint32_t i, const NeighbourTable::Row&, const Likeness& along) {
            double against = 0, all = 0;
            for (std::size_t k = 0; k < edges.count(); ++k) {
                const double weight = 1 - along.unlike[k] / static_cast<double>(unlikeClasses - 1);
                all += weight;
                against += along.flip[k] ? weight : 0;
            }
            out[i] = against > doubtfulShare * all;
        });
    });
    return out;
}

} // namespace process
