#include "core/mesh/marching/fill_loop.h"

#include <algorithm>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double never = 1e300;

double costOf(const LoopShape& shape, int i, int j, int k) {
    constexpr double disagreement = 3;
    const Vec3d& a = shape.positions[std::size_t(i)];
    const Vec3d& b = shape.positions[std::size_t(j)];
    const Vec3d& c = shape.positions[std::size_t(k)];
    const Vec3d normal = base::normalized(cross(b - a, c - a));
    double agree = 0;
    for (const int corner : {i, j, k})
        agree += std::abs(dot(normal, base::cast<double>(shape.normals[std::size_t(corner)]))) / 3;
    return (distanceSq(a, b) + distanceSq(b, c) + distanceSq(c, a)) * (1 + disagreement * (1 - agree));
}

/// The least cost of filling the part from i to j, by the corner of its triangle.
class LoopFill {
  public:
    explicit LoopFill(const LoopShape& shape)
        : m_shape(shape), m_count(static_cast<int>(shape.loop.size())), m_cost(std::size_t(m_count * m_count), never),
          m_corner(std::size_t(m_count * m_count), -1) {}

    bool run(std::vector<std::array<int, 3>>& out) {
        for (int i = 0; i + 1 < m_count; ++i)
            cost(i, i + 1) = 0;
        for (int length = 2; length < m_count; ++length)
            for (int i = 0; i + length < m_count; ++i)
                fill(i, i + length);
        if (cost(0, m_count - 1) >= never)
            return false;
        collect(0, m_count - 1, out);
        return true;
    }

  private:
    double& cost(int i, int j) { return m_cost[std::size_t(i * m_count + j)]; }
    int& corner(int i, int j) { return m_corner[std::size_t(i * m_count + j)]; }

    void fill(int i, int j) {
        const bool side = i == 0 && j == m_count - 1;
        if (!side && (m_shape.loop[std::size_t(i)].faces & m_shape.loop[std::size_t(j)].faces))
            return;
        for (int k = i + 1; k < j; ++k) {
            if (cost(i, k) >= never || cost(k, j) >= never)
                continue;
            const double sum = cost(i, k) + cost(k, j) + costOf(m_shape, i, k, j);
            if (sum < cost(i, j))
                cost(i, j) = sum, corner(i, j) = k;
        }
    }

    void collect(int i, int j, std::vector<std::array<int, 3>>& out) {
        if (j - i < 2)
            return;
        const int k = corner(i, j);
        collect(i, k, out);
        out.push_back({i, k, j});
        collect(k, j, out);
    }

    const LoopShape& m_shape;
    int m_count;
    std::vector<double> m_cost;
    std::vector<int> m_corner;
};

} // namespace

bool fillLoop(const LoopShape& shape, std::vector<std::array<int, 3>>& out) {
    out.clear();
    const int count = static_cast<int>(shape.loop.size());
    if (count < 3) // a cube that the surface touches along an edge: its neighbours meet there
        return false;
    if (count == 3) {
        out.push_back({0, 1, 2});
        return false;
    }
    if (LoopFill(shape).run(out))
        return false;
    for (int i = 0; i < count; ++i)
        out.push_back({i, (i + 1) % count, count});
    return true;
}

} // namespace mesh
