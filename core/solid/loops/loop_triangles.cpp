#include "core/solid/loops/loop_triangles.h"

#include "core/base/parallel.h"

#include <limits>

namespace solid {

using base::Vec3d;

namespace {

/// Triangulations of the corners i to j, by the apex k of the triangle at the chord from i to j.
class Table {
  public:
    Table(std::span<const Vec3d> polygon, std::span<const Vec3d> normals)
        : m_points(polygon), m_normals(normals), m_size(polygon.size()), m_cost(m_size * m_size, 0),
          m_apex(m_size * m_size, 0) {}

    void fill() {
        for (std::size_t width = 2; width < m_size; ++width)
            base::parallelFor(m_size - width, 16, [&](std::size_t i) { choose(i, i + width); });
    }
    void collect(std::vector<mesh::Triangle>& out) const {
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, m_size - 1}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (j < i + 2)
                continue;
            const std::size_t k = m_apex[i * m_size + j];
            out.push_back(
                {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(j)});
            open.push_back({i, k});
            open.push_back({k, j});
        }
    }

  private:
    /// Of the triangle (or the surface) at the chord from i to j.
    Vec3d normalAt(std::size_t i, std::size_t j) const {
        if (j == i + 1)
            return normalized(m_normals[i] + m_normals[j]);
        return normalOf(i, m_apex[i * m_size + j], j);
    }
    Vec3d normalOf(std::size_t i, std::size_t k, std::size_t j) const {
        return normalized(cross(m_points[k] - m_points[i], m_points[j] - m_points[i]));
    }
    /// 0 up to an angle of 120 degrees between two normals, then up to the squared length of the edge, 4 times.
    double fold(const Vec3d& a, const Vec3d& b, std::size_t i, std::size_t j) const {
        return 8 * std::max(0.0, -dot(a, b) - 0.5) * distanceSq(m_points[i], m_points[j]);
    }
    void choose(std::size_t i, std::size_t j) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = i + 1; k < j; ++k) {
            double cost = m_cost[i * m_size + k] + m_cost[k * m_size + j];
            if (cost >= least)
                continue;
            const Vec3d twice = cross(m_points[k] - m_points[i], m_points[j] - m_points[i]), n = normalized(twice);
            cost += 0.5 * length(twice) + fold(n, normalAt(i, k), i, k) + fold(n, normalAt(k, j), k, j);
            if (i == 0 && j + 1 == m_size)
                cost += fold(n, normalized(m_normals[i] + m_normals[j]), i, j);
            if (cost < least) {
                least = cost;
                m_apex[i * m_size + j] = k;
            }
        }
        if (m_apex[i * m_size + j] == 0) // places that are not finite
            m_apex[i * m_size + j] = i + 1;
        m_cost[i * m_size + j] = least;
    }

    std::span<const Vec3d> m_points, m_normals;
    std::size_t m_size;
    std::vector<double> m_cost;
    std::vector<std::size_t> m_apex;
};

} // namespace

std::vector<mesh::Triangle> trianglesOver(std::span<const Vec3d> polygon, std::span<const Vec3d> normals) {
    Table table(polygon, normals);
    table.fill();
    std::vector<mesh::Triangle> out;
    table.collect(out);
    return out;
}

} // namespace solid
