#include "core/mesh/faces/sample_normals.h"

#include "core/mesh/faces/face_normals.h"

#include <cmath>

namespace mesh {

using base::Vec3f;

namespace {

constexpr double smoothOver = 3; ///< spacings: triangles of this size and smaller lend their corners' normals whole

} // namespace

SampleNormals::SampleNormals(const FaceTopology& topology, std::span<const Vec3f> positions)
    : m_topology(topology), m_positions(positions), m_fans(fanNormals(topology, positions)) {}

SampleNormals::Side SampleNormals::longestSide(std::uint32_t triangle) const {
    const Triangle& t = m_topology.triangles[triangle];
    Side out;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f way = m_positions[t[(k + 1) % 3]] - m_positions[t[k]];
        if (const double length = static_cast<double>(base::length(way)); length > out.length)
            out = {way, length};
    }
    out.along = normalized(out.along);
    return out;
}

Vec3f SampleNormals::at(const FacePoint& point, double spacing, std::span<const std::uint8_t> tips) const {
    const std::array<float, 3> weights = point.weights();
    const Vec3f face = base::cast<float>(m_topology.normals[point.triangle]);
    Vec3f blended;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t fan = m_topology.fans[3 * point.triangle + k];
        blended += (!tips.empty() && tips[fan] != 0 ? face : m_fans[fan]) * weights[k];
    }
    blended = normalized(blended, face);
    // each way as far as the triangle is small that way: what a chamfer's long triangles meet at their far ends says
    // nothing of the chamfer
    const auto shareOf = [&](double size) {
        return static_cast<float>(size > smoothOver * spacing ? smoothOver * spacing / size : 1);
    };
    const Side side = longestSide(point.triangle);
    const float lengthwise = shareOf(side.length), across = shareOf(std::sqrt(2 * m_topology.areas[point.triangle]));
    const float ahead = dot(blended, face), sideways = dot(blended, side.along);
    const Vec3f rest = blended - face * ahead - side.along * sideways;
    return normalized(side.along * (sideways * lengthwise) + rest * across + face * (1 + (ahead - 1) * across), face);
}

} // namespace mesh
