#include "core/mesh/marching/cube_filler.h"

#include <numeric>
#include <tuple>

namespace mesh {

using base::Vec3d, base::Vec3f;

std::vector<Vec3d> CubePart::centres(const Mesh& mesh) const {
    std::vector<Vec3d> out;
    for (const Triangle& t : triangles) {
        Vec3d sum;
        for (const std::uint32_t v : t)
            sum += v & middleBit ? middles[v & ~middleBit] : mesh.positions[v];
        out.push_back(sum / 3);
    }
    return out;
}

void CubeFiller::fill(const std::vector<Loop>& loops) {
    for (const Loop& loop : loops)
        fill(loop);
    m_out.cubes += loops.empty() ? 0 : 1;
}

void CubeFiller::fill(const Loop& loop) {
    m_positions.clear();
    m_normals.clear();
    for (const LoopVertex& each : loop) {
        m_positions.push_back(m_mesh.positions[each.vertex]);
        m_normals.push_back(m_mesh.normals[each.vertex]);
    }
    if (fillLoop({loop, m_positions, m_normals}, m_triangles))
        addMiddle();
    const bool turned = m_oriented && facing() < 0;
    for (const auto& t : m_triangles) {
        const Triangle named{name(loop, t[0]), name(loop, t[1]), name(loop, t[2])};
        m_out.triangles.push_back(turned ? Triangle{named[0], named[2], named[1]} : named);
    }
}

void CubeFiller::addMiddle() {
    const double count = static_cast<double>(m_positions.size());
    const Vec3d middle = std::accumulate(m_positions.begin(), m_positions.end(), Vec3d{}) / count;
    Vec3f normal = m_normals[0];
    for (const Vec3f& each : m_normals)
        normal += dot(each, m_normals[0]) < 0 ? -each : each;
    m_positions.push_back(middle);
    m_normals.push_back(base::normalized(normal, m_normals[0]));
    m_out.middles.push_back(middle);
    m_out.middleNormals.push_back(m_normals.back());
}

/// Above zero where triangles run around the normals.
double CubeFiller::facing() const {
    double sum = 0;
    for (const auto& t : m_triangles) {
        const auto [i, j, k] = std::tuple(std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]));
        const Vec3d area = cross(m_positions[j] - m_positions[i], m_positions[k] - m_positions[i]);
        sum += dot(area, base::cast<double>(m_normals[i] + m_normals[j] + m_normals[k]));
    }
    return sum;
}

std::uint32_t CubeFiller::name(const Loop& loop, int i) const {
    return std::size_t(i) < loop.size() ? loop[std::size_t(i)].vertex
                                        : CubePart::middleBit | static_cast<std::uint32_t>(m_out.middles.size() - 1);
}

} // namespace mesh
