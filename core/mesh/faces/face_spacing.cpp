#include "core/mesh/faces/face_spacing.h"

#include "core/process/neighbours/knn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

constexpr std::size_t leastCount = 100'000, mostForWalls = 1'000'000, mostCount = 5'000'000;
/// What vertices may be instead of samples (mesh/README 8.2).
constexpr double coarsestEdges = 2.5; ///< over the spacing of `leastCount` samples, in the median: some 20,000 vertices
constexpr double mostSharp = 0.025;   ///< of the edges' length
constexpr float resolvedTurn = static_cast<float>(std::numbers::pi / 12); ///< of normals within a spacing: 15 degrees

static Vec3d corner(std::span<const Vec3f> positions, const Triangle& t, std::size_t k) {
    return base::cast<double>(positions[t[k % 3]]);
}

std::vector<float> vertexSpacings(const FaceTopology& topology, std::span<const Vec3f> positions) {
    std::vector<double> share(positions.size()), turn(positions.size());
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& f = topology.triangles[t];
            const Vec3d p = corner(positions, f, k), a = corner(positions, f, k + 1) - p,
                        b = corner(positions, f, k + 2) - p;
            share[f[k]] += topology.areas[t] / 3;
            turn[f[k]] += std::atan2(length(cross(a, b)), dot(a, b));
        }
    for (std::size_t i = 0; i < share.size(); ++i)
        if (turn[i] > 0)
            share[i] *= std::max(1.0, 2 * std::numbers::pi / turn[i]);
    std::vector<double> sum = share, weight(share.size(), 1);
    for (const Triangle& f : topology.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum[f[k]] += (share[f[(k + 1) % 3]] + share[f[(k + 2) % 3]]) / 2, ++weight[f[k]];
    std::vector<float> out(share.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = turn[i] > 0 ? static_cast<float>(std::sqrt(sum[i] / weight[i])) : 0;
    return out;
}

static float quantile(std::vector<float>& values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

bool sampleWell(const FaceTopology& topology, std::span<const Vec3f> positions) {
    std::vector<float> edges, spacings, turns = topology.turns;
    for (const Triangle& f : topology.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back(distance(positions[f[k]], positions[f[(k + 1) % 3]]));
    for (const float s : vertexSpacings(topology, positions))
        if (s > 0)
            spacings.push_back(s);
    if (spacings.empty() || turns.empty())
        return false;
    const double samples = std::sqrt(topology.area / static_cast<double>(leastCount));
    return static_cast<double>(quantile(edges, 0.5)) < coarsestEdges * samples && topology.sharpShare < mostSharp &&
           quantile(turns, 0.95) < 2 * resolvedTurn && quantile(spacings, 0.95) < 2.5f * quantile(spacings, 0.05);
}

constexpr double opposite = -0.9;    ///< cosine of walls that meet at less than 26 degrees
constexpr double parallel = -0.9986; ///< of 3 degrees: nearer than that walls run on as those of a plate do

/// Patches of which two meet in edges of acute wedges. Between them walls get thinner up to the edge, however fine the
/// samples are: it is no thickness that more of these resolve.
class Wedges {
  public:
    explicit Wedges(const FaceTopology& topology) : m_topology(topology) {
        for (const SharpEdge& edge : topology.sharpEdges)
            if (edge.convex && dot(topology.normals[edge.left], topology.normals[edge.right]) < opposite)
                m_pairs.push_back(pairOf(edge.left, edge.right));
        std::sort(m_pairs.begin(), m_pairs.end());
        m_pairs.erase(std::unique(m_pairs.begin(), m_pairs.end()), m_pairs.end());
    }
    bool has(std::uint32_t one, std::uint32_t other) const {
        return dot(m_topology.normals[one], m_topology.normals[other]) > parallel &&
               std::binary_search(m_pairs.begin(), m_pairs.end(), pairOf(one, other));
    }

  private:
    std::uint64_t pairOf(std::uint32_t one, std::uint32_t other) const {
        const std::uint64_t a = m_topology.patches[one], b = m_topology.patches[other];
        return std::min(a, b) << 32 | std::max(a, b);
    }
    const FaceTopology& m_topology;
    std::vector<std::uint64_t> m_pairs;
};

/// Distance to the wall behind, for points spread over the faces, as far as a few of their own spacings; infinity
/// beyond. Where two flanks run together to a sharp edge there is none. `spacings`: of each piece, or one for all.
static std::vector<float> wallsBehind(const FaceTopology& topology, std::span<const Vec3f> positions,
                                      std::span<const FacePoint> points, std::span<const double> spacings,
                                      const base::Progress& progress) {
    std::vector<surfel::Surfel> places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        places[i].position = base::cast<float>(placeOf(points[i], topology, positions));
    const process::Cloud cloud(places, progress);
    std::vector<float> out(points.size(), std::numeric_limits<float>::infinity());
    std::vector<std::uint32_t> some(cloud.size()); // of points at one place, one speaks
    for (std::uint32_t i = 0; i < points.size(); ++i)
        some[cloud.places()[i]] = i;
    constexpr std::size_t neighbours = 32;
    const Wedges wedges(topology);
    cloud.forEach(neighbours, progress, "Measuring walls", [&](std::size_t i, const process::Neighbours& near) {
        const std::uint32_t self = some[i];
        const Vec3d n = topology.normals[points[self].triangle];
        const std::uint32_t piece = topology.pieces[points[self].triangle];
        const auto reach = static_cast<float>(spacings.size() == 1 ? spacings[0] : spacings[piece]);
        for (std::size_t k = 0; k < near.size(); ++k) {
            const std::uint32_t other = some[near.index[k]];
            const Vec3d to = base::cast<double>(places[other].position) - base::cast<double>(places[self].position);
            const double depth = -dot(to, n);
            if (dot(n, topology.normals[points[other].triangle]) < opposite && depth > 0 &&
                lengthSq(to) - depth * depth < static_cast<double>(reach * reach) &&
                !wedges.has(points[self].triangle, points[other].triangle))
                out[self] = std::min(out[self], static_cast<float>(depth));
        }
    });
    return out;
}

bool hasBlades(const FaceTopology& topology) {
    constexpr double blade = -0.5;
    return std::ranges::any_of(topology.sharpEdges, [&](const SharpEdge& edge) {
        return edge.convex && dot(topology.normals[edge.left], topology.normals[edge.right]) < blade;
    });
}

double thinnestWall(const FaceTopology& topology, std::span<const Vec3f> positions, const base::Progress& progress,
                    const InnerPlaces* inside) {
    constexpr std::size_t probes = leastCount / 5; // what is thinner than three spacings of leastCount is found
    const double area = topology.area * (inside ? inside->outerShare() : 1);
    const double spacing = std::sqrt(area / static_cast<double>(probes));
    std::vector<float> walls =
        wallsBehind(topology, positions, spreadPoints(topology, positions, probes, progress, inside),
                    std::span(&spacing, 1), progress);
    return walls.empty() ? std::numeric_limits<double>::infinity() : static_cast<double>(quantile(walls, 0.01));
}

std::vector<double> thinnestWalls(const FaceTopology& topology, std::span<const Vec3f> positions,
                                  std::span<const FacePoint> points, std::span<const double> spacings,
                                  const base::Progress& progress) {
    const std::vector<float> walls = wallsBehind(topology, positions, points, spacings, progress);
    std::vector<std::vector<float>> ofPieces(topology.pieceCount);
    for (std::size_t i = 0; i < points.size(); ++i)
        ofPieces[topology.pieces[points[i].triangle]].push_back(walls[i]);
    std::vector<double> out;
    for (std::vector<float>& each : ofPieces)
        out.push_back(each.empty() ? std::numeric_limits<double>::infinity()
                                   : static_cast<double>(quantile(each, 0.01)));
    return out;
}

std::size_t fittingCount(const FaceTopology& topology, double thinnestWall, double share) {
    const double spacing = thinnestWall / 3;
    const double walls = std::min(topology.area / (spacing * spacing), static_cast<double>(mostForWalls)) * share;
    const double wanted = std::max(walls, static_cast<double>(topology.triangles.size()));
    return static_cast<std::size_t>(
        std::clamp(wanted, static_cast<double>(leastCount), static_cast<double>(mostCount)));
}

} // namespace mesh
