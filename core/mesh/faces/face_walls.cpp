#include "core/mesh/faces/face_walls.h"

#include "core/process/neighbours/knn.h"

#include <algorithm>
#include <limits>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

namespace {

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

} // namespace

std::vector<float> wallsBehind(const FaceTopology& topology, std::span<const Vec3f> positions,
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
        const auto reach = static_cast<float>(spacings[piece]);
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

} // namespace mesh
