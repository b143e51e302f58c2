#include "core/mesh/faces/turn_outwards.h"

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/base/random.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mesh {

namespace {

using base::Vec3d;
using base::Vec3f;

constexpr double smallHoles = 0.01;  ///< of the area: the square of the border's length
constexpr double leastVolume = 1e-6; ///< of the area to the power of 1.5: a ball has 0.094
constexpr std::uint64_t probesPerPiece = 5;
constexpr std::uint64_t seed = 0x6f757477617264ULL;

struct Piece {
    double area = 0, volume = 0; ///< volume: above zero where faces look outwards
    Vec3d middle;
    bool closed = false;
};

class Pieces {
  public:
    Pieces(const FacePieces& given, std::span<const Triangle> triangles, std::span<const double> areas,
           std::span<const Vec3f> positions)
        : m_given(given), m_triangles(triangles), m_areas(areas), m_positions(positions),
          m_pieces(given.borders.size()) {
        measure();
    }

    std::vector<Facing> run() {
        std::vector<Facing> out(m_pieces.size());
        for (std::size_t p = 0; p < out.size(); ++p)
            out[p] = m_pieces[p].closed ? Facing::Outwards : Facing::Open;
        if (std::none_of(m_pieces.begin(), m_pieces.end(), [](const Piece& p) { return p.closed && p.volume < 0; }))
            return out;
        const std::vector<std::vector<std::uint32_t>> around = enclosing();
        for (std::size_t p = 0; p < out.size(); ++p) {
            std::size_t outermost = p; // around it, and with nothing around itself; the largest if several
            for (const std::uint32_t other : around[p])
                if (around[other].empty() && (outermost == p || m_pieces[other].area > m_pieces[outermost].area))
                    outermost = other;
            if (m_pieces[p].closed && m_pieces[outermost].volume < 0)
                out[p] = Facing::Inwards;
        }
        return out;
    }

  private:
    Vec3d corner(std::size_t t, std::size_t k) const { return base::cast<double>(m_positions[m_triangles[t][k]]); }

    void measure() {
        for (std::size_t t = 0; t < m_triangles.size(); ++t) {
            Piece& piece = m_pieces[m_given.of[t]];
            piece.area += m_areas[t];
            piece.middle += (corner(t, 0) + corner(t, 1) + corner(t, 2)) * (m_areas[t] / 3);
        }
        for (Piece& piece : m_pieces)
            if (piece.area > 0)
                piece.middle = piece.middle / piece.area;
        for (std::size_t t = 0; t < m_triangles.size(); ++t) {
            Piece& piece = m_pieces[m_given.of[t]];
            const Vec3d a = corner(t, 0) - piece.middle, b = corner(t, 1) - piece.middle,
                        c = corner(t, 2) - piece.middle;
            piece.volume += dot(a, cross(b, c)) / 6;
        }
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            Piece& piece = m_pieces[p];
            piece.closed = m_given.borders[p] * m_given.borders[p] <= smallHoles * piece.area &&
                           std::abs(piece.volume) > leastVolume * piece.area * std::sqrt(piece.area);
        }
    }

    /// Places on faces of each closed piece, uniform by area.
    struct Probe {
        Vec3d at;
        std::uint32_t piece;
    };
    std::vector<Probe> probes() const {
        std::vector<double> sums(m_pieces.size()); // areas so far
        std::vector<std::vector<double>> wanted(m_pieces.size());
        for (std::size_t p = 0; p < m_pieces.size(); ++p) {
            base::Random random(base::mix(seed ^ p));
            for (std::uint64_t i = 0; m_pieces[p].closed && i < probesPerPiece; ++i)
                wanted[p].push_back((static_cast<double>(i) + random.uniform()) / probesPerPiece * m_pieces[p].area);
        }
        std::vector<Probe> out;
        std::vector<std::size_t> next(m_pieces.size());
        for (std::size_t t = 0; t < m_triangles.size(); ++t) {
            const std::uint32_t p = m_given.of[t];
            sums[p] += m_areas[t];
            for (; next[p] < wanted[p].size() && wanted[p][next[p]] <= sums[p]; ++next[p]) {
                base::Random random(base::mix(seed ^ ~(t * probesPerPiece + next[p])));
                double u = random.uniform(), v = random.uniform();
                if (u + v > 1)
                    u = 1 - u, v = 1 - v;
                const Vec3d a = corner(t, 0);
                out.push_back({a + (corner(t, 1) - a) * u + (corner(t, 2) - a) * v, p});
            }
        }
        return out;
    }

    /// Each closed piece's closed pieces around it: those that hold most of its probes. From each probe runs a ray
    /// along x, and the faces that it crosses are counted; probes are found by y and z in a grid.
    std::vector<std::vector<std::uint32_t>> enclosing() const {
        const std::vector<Probe> all = probes();
        base::Box3d box;
        for (const Probe& p : all)
            box.extend(p.at);
        const auto cells = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(all.size()))));
        const auto cellOf = [&](double value, std::size_t axis) {
            const double size = box.hi[axis] - box.lo[axis];
            const double at = size > 0 ? (value - box.lo[axis]) / size * static_cast<double>(cells) : 0;
            return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(cells - 1)));
        };
        std::vector<std::vector<std::uint32_t>> grid(cells * cells);
        for (std::uint32_t i = 0; i < all.size(); ++i)
            grid[cellOf(all[i].at.y, 1) * cells + cellOf(all[i].at.z, 2)].push_back(i);
        struct Crossing {
            std::uint32_t probe, piece;
            auto operator<=>(const Crossing&) const = default;
        };
        std::vector<std::vector<Crossing>> found(base::chunkCount(m_triangles.size(), grain));
        base::parallelChunks(m_triangles.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t t = begin; t < end; ++t) {
                if (!m_pieces[m_given.of[t]].closed)
                    continue;
                base::Box3d around;
                for (std::size_t k = 0; k < 3; ++k)
                    around.extend(corner(t, k));
                if (around.hi.y < box.lo.y || around.lo.y > box.hi.y || around.hi.z < box.lo.z ||
                    around.lo.z > box.hi.z)
                    continue;
                for (std::size_t y = cellOf(around.lo.y, 1); y <= cellOf(around.hi.y, 1); ++y)
                    for (std::size_t z = cellOf(around.lo.z, 2); z <= cellOf(around.hi.z, 2); ++z)
                        for (const std::uint32_t i : grid[y * cells + z])
                            if (all[i].piece != m_given.of[t] && crosses(t, all[i].at))
                                found[chunk].push_back({i, m_given.of[t]});
            }
        });
        std::vector<Crossing> crossings;
        for (const auto& part : found)
            crossings.insert(crossings.end(), part.begin(), part.end());
        std::sort(crossings.begin(), crossings.end());
        std::vector<Crossing> inside; // the piece of the probe, and the one around it
        for (std::size_t begin = 0, end; begin < crossings.size(); begin = end) {
            for (end = begin; end < crossings.size() && crossings[end] == crossings[begin];)
                ++end;
            if ((end - begin) % 2 == 1)
                inside.push_back({all[crossings[begin].probe].piece, crossings[begin].piece});
        }
        std::sort(inside.begin(), inside.end());
        std::vector<std::vector<std::uint32_t>> out(m_pieces.size());
        for (std::size_t begin = 0, end; begin < inside.size(); begin = end) {
            for (end = begin; end < inside.size() && inside[end] == inside[begin];)
                ++end;
            if (2 * (end - begin) > probesPerPiece)
                out[inside[begin].probe].push_back(inside[begin].piece);
        }
        return out;
    }

    /// Does the ray from `from` along +x cross triangle t? What runs through an edge belongs to one side of it alone:
    /// sides are compared from their lower place on, so that both triangles reckon the same.
    bool crosses(std::size_t t, const Vec3d& from) const {
        std::array<Vec3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = corner(t, k);
        bool odd = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d &a = p[k].y < p[(k + 1) % 3].y ? p[k] : p[(k + 1) % 3],
                        &b = p[k].y < p[(k + 1) % 3].y ? p[(k + 1) % 3] : p[k];
            if (a.y <= from.y && from.y < b.y)
                odd ^= (b.z - a.z) * (from.y - a.y) > (from.z - a.z) * (b.y - a.y);
        }
        if (!odd)
            return false;
        const Vec3d n = cross(p[1] - p[0], p[2] - p[0]);
        return n.x != 0 && dot(p[0] - from, n) / n.x > 0;
    }

    static constexpr std::size_t grain = 4096;
    const FacePieces& m_given;
    std::span<const Triangle> m_triangles;
    std::span<const double> m_areas;
    std::span<const Vec3f> m_positions;
    std::vector<Piece> m_pieces;
};

} // namespace

std::vector<Facing> facingOf(const FacePieces& pieces, std::span<const Triangle> triangles,
                             std::span<const double> areas, std::span<const Vec3f> positions) {
    return Pieces(pieces, triangles, areas, positions).run();
}

} // namespace mesh
