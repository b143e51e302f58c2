#include "core/mesh/marching/grid_face.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

SurfaceGrid::EdgeName GridFace::edge(const GridIndex& place, int axis, int side) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    switch (side) {
    case 0:
        return {place, u};
    case 1:
        return {place.next(u), v};
    case 2:
        return {place.next(v), u};
    default:
        return {place, v};
    }
}

std::array<SurfaceGrid::EdgeName, 4> SurfaceGrid::edgesOf(const GridFace& face) {
    std::array<EdgeName, 4> out;
    for (int side = 0; side < 4; ++side)
        out[std::size_t(side)] = GridFace::edge(face.place, face.axis, side);
    return out;
}

bool faceAt(const SurfaceGrid& grid, const Neighbourhood& around, const GridIndex& place, int axis, GridFace& out) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (around.rank(place.next(u).next(v)) == noRank)
        return false;
    out.place = place;
    out.axis = axis;
    out.count = 0;
    for (int side = 0; side < 4; ++side) {
        const SurfaceGrid::EdgeName edge = GridFace::edge(place, axis, side);
        const std::uint32_t node = around.rank(edge.node);
        if (node == noRank)
            return false;
        const std::uint32_t crossing = grid.crossingOf(node, edge.axis);
        if (crossing >= SurfaceGrid::none)
            continue;
        out.crossing[static_cast<std::size_t>(out.count)] = crossing;
        out.side[static_cast<std::size_t>(out.count++)] = side;
    }
    return true;
}

namespace {

constexpr double steepest = 0.9; ///< |n.d| of a segment that still runs along the surface at its end
constexpr double level = 0.05;   ///< of normals in the face: with less they lie on neither side of a segment
constexpr double never = 1e30;
constexpr double wrongSide = 4; ///< of closed surfaces: more than any two other segments cost

/// What a segment between two crossings costs: how far it leaves the surface at its ends. Of a closed surface every
/// crossing has a partner: what would forbid a segment elsewhere only makes it dear.
double costOf(const CrossingGrid& grid, const GridFace& face, std::size_t i, std::size_t j) {
    const Crossing& a = grid.crossings()[face.crossing[i]];
    const Crossing& b = grid.crossings()[face.crossing[j]];
    const Vec3d d = base::normalized(b.position - a.position);
    const Vec3d na = base::cast<double>(a.normal), nb = base::cast<double>(b.normal);
    const double outA = std::abs(dot(na, d)), outB = std::abs(dot(nb, d));
    const bool closed = a.sided && b.sided;
    if (!closed && std::max(outA, outB) > steepest)
        return never;
    if (grid.traits().oriented) {
        const Vec3d across = cross(d, grid.lattice().direction(face.axis));
        const double sideA = dot(na, across), sideB = dot(nb, across);
        if (sideA * sideB < 0 && std::min(std::abs(sideA), std::abs(sideB)) > level)
            return closed ? outA + outB + wrongSide : never;
    }
    return outA + outB;
}

/// The best pairs of any number of crossings, by trying all.
template <class Cost>
class BestPairs {
  public:
    explicit BestPairs(const Cost& cost) : m_cost(cost) {}

    struct Choice {
        int count = 0;
        double cost = 0;
        FacePairs pairs;
    };
    /// Of the crossings from `begin` up to `end`.
    Choice among(int begin, int end) const {
        if (end - begin < 2)
            return {};
        Choice best = among(begin + 1, end);
        for (int k = begin + 1; k < end; ++k) {
            const double c = m_cost(static_cast<std::size_t>(begin), static_cast<std::size_t>(k));
            if (c >= never)
                continue;
            const Choice within = among(begin + 1, k), beyond = among(k + 1, end);
            const int count = 1 + within.count + beyond.count;
            const double sum = c + within.cost + beyond.cost;
            if (count > best.count || (count == best.count && sum < best.cost))
                best = {count, sum, joined(within.pairs, beyond.pairs, begin, k)};
        }
        return best;
    }

  private:
    static FacePairs joined(FacePairs out, const FacePairs& more, int i, int k) {
        for (std::size_t at = 0; at < out.partner.size(); ++at)
            out.partner[at] = std::max(out.partner[at], more.partner[at]);
        out.partner[static_cast<std::size_t>(i)] = k;
        out.partner[static_cast<std::size_t>(k)] = i;
        return out;
    }

    const Cost& m_cost;
};

} // namespace

FacePairs pairsOf(const CrossingGrid& grid, const GridFace& face) {
    FacePairs out;
    if (face.count < 2)
        return out;
    const auto cost = [&](std::size_t i, std::size_t j) { return costOf(grid, face, i, j); };
    const auto join = [&](int i, int j) {
        out.partner[static_cast<std::size_t>(i)] = j;
        out.partner[static_cast<std::size_t>(j)] = i;
    };
    // of all sets of pairs that do not cross: the most pairs, then the least cost
    double best = 2 * never;
    int pairs = 0;
    FacePairs chosen;
    const auto consider = [&](std::initializer_list<std::pair<int, int>> some) {
        double sum = 0;
        int count = 0;
        out = {};
        for (const auto& [i, j] : some) {
            const double c = cost(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
            if (c >= never)
                continue;
            sum += c;
            ++count;
            join(i, j);
        }
        if (count > pairs || (count == pairs && sum < best))
            best = sum, pairs = count, chosen = out;
    };
    if (face.count == 2) {
        consider({{0, 1}});
    } else if (face.count == 3) {
        consider({{0, 1}});
        consider({{1, 2}});
        consider({{0, 2}});
    } else if (face.count > 4) {
        return BestPairs(cost).among(0, face.count).pairs;
    } else {
        consider({{0, 1}, {2, 3}});
        consider({{1, 2}, {3, 0}});
    }
    return chosen;
}

} // namespace mesh
