#include "app/bench/naive/naive_march.h"

#include "app/bench/naive/naive_cloud.h"
#include "core/base/box.h"

#include <limits>

namespace bench {

using base::Vec3d;

namespace {

constexpr auto unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t none = ~0u;

/// Corners of a cube: bit 0 along x, bit 1 along y, bit 2 along z. Faces as loops of corners.
constexpr unsigned faces[6][4] = {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};

class Grid {
  public:
    Grid(const NaiveSurface& surface, double cell) : m_cell(cell) {
        base::Box3f box;
        for (const auto& bucket : surface.cloud().buckets())
            for (const surfel::Surfel& s : bucket.surfels)
                box.extend(s.position);
        m_lo = base::cast<double>(box.lo) - Vec3d{1, 1, 1} * (2.5 * cell);
        for (std::size_t axis = 0; axis < 3; ++axis)
            m_count[axis] = static_cast<std::size_t>(static_cast<double>(box.size()[axis]) / cell) + 6;
        m_value.assign(m_count[0] * m_count[1] * m_count[2], unknown);
        m_vertex.assign(3 * m_value.size(), none);
        evaluate(surface);
    }
    NaiveMesh march() {
        for (const std::size_t cube : m_near)
            fill(cube);
        return std::move(m_mesh);
    }

  private:
    std::size_t stride(std::size_t axis) const {
        return axis == 0 ? 1 : axis == 1 ? m_count[0] : m_count[0] * m_count[1];
    }
    std::size_t corner(std::size_t cube, unsigned bits) const {
        return cube + (bits & 1) + (bits >> 1 & 1) * stride(1) + (bits >> 2 & 1) * stride(2);
    }
    Vec3d place(std::size_t node) const {
        const std::size_t x = node % m_count[0], y = node / stride(1) % m_count[1], z = node / stride(2);
        return m_lo + Vec3d{double(x), double(y), double(z)} * m_cell;
    }
    /// The nodes of the 3 x 3 x 3 cubes about each surfel.
    void evaluate(const NaiveSurface& surface) {
        std::vector<bool> seen(m_value.size());
        for (const auto& bucket : surface.cloud().buckets())
            for (const surfel::Surfel& s : bucket.surfels) {
                const Vec3d at = (base::cast<double>(s.position) - m_lo) / m_cell;
                const std::size_t first =
                    std::size_t(at.x) - 1 + (std::size_t(at.y) - 1) * stride(1) + (std::size_t(at.z) - 1) * stride(2);
                for (std::size_t i = 0; i < 64; ++i) {
                    const std::size_t node = first + i % 4 + i / 4 % 4 * stride(1) + i / 16 * stride(2);
                    if (seen[node])
                        continue;
                    seen[node] = true;
                    m_near.push_back(node);
                    if (const NaiveEvaluation e = surface.evaluate(place(node), surface::Need::Value); e.valid)
                        m_value[node] = e.value;
                }
            }
    }
    /// The crossing between two corners of a cube, shared by the cubes about the edge.
    std::uint32_t crossing(std::size_t cube, unsigned a, unsigned b) {
        if (a > b)
            std::swap(a, b);
        const std::size_t axis = (a ^ b) >> 1, from = corner(cube, a), to = corner(cube, b);
        std::uint32_t& vertex = m_vertex[3 * from + axis];
        if (vertex == none) {
            vertex = static_cast<std::uint32_t>(m_mesh.vertices.size());
            const double part = m_value[from] / (m_value[from] - m_value[to]);
            m_mesh.vertices.push_back(place(from) + (place(to) - place(from)) * part);
        }
        return vertex;
    }
    /// Follows the crossings from face to face around the cube and fills each loop with a fan.
    void fill(std::size_t cube) {
        double f[8];
        unsigned inside = 0;
        for (unsigned c = 0; c < 8; ++c) {
            f[c] = m_value[corner(cube, c)];
            if (!std::isfinite(f[c]))
                return;
            inside += f[c] < 0 ? 1 : 0;
        }
        if (inside == 0 || inside == 8)
            return;
        std::pair<std::uint32_t, std::uint32_t> links[12];
        std::size_t count = 0;
        for (const auto& face : faces) {
            std::uint32_t cut[4];
            std::size_t cuts = 0;
            for (unsigned k = 0; k < 4; ++k)
                if (const unsigned a = face[k], b = face[(k + 1) % 4]; (f[a] < 0) != (f[b] < 0))
                    cut[cuts++] = crossing(cube, a, b);
            for (std::size_t k = 0; k < cuts; k += 2)
                links[count++] = {cut[k], cut[k + 1]};
        }
        while (count > 0) {
            const auto [first, second] = links[--count];
            for (std::uint32_t last = second; last != first;) {
                std::size_t k = 0;
                while (k < count && links[k].first != last && links[k].second != last)
                    ++k;
                if (k == count)
                    break;
                const std::uint32_t next = links[k].first == last ? links[k].second : links[k].first;
                links[k] = links[--count];
                if (next != first)
                    m_mesh.triangles.push_back({first, last, next});
                last = next;
            }
        }
    }

    double m_cell;
    Vec3d m_lo;
    std::size_t m_count[3] = {};
    std::vector<double> m_value;         ///< per node; NaN: none
    std::vector<std::uint32_t> m_vertex; ///< per node and axis
    std::vector<std::size_t> m_near;     ///< nodes evaluated; each is also the low corner of a cube
    NaiveMesh m_mesh;
};

} // namespace

NaiveMesh naiveMarch(const NaiveSurface& surface, double cell) {
    return Grid(surface, cell).march();
}

} // namespace bench
