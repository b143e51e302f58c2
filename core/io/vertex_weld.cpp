#include "core/io/vertex_weld.h"

#include "core/base/random.h"

#include <bit>
#include <limits>

namespace io {

namespace {

/// Open addressing over the indices of points; the table is at most half full.
class PointTable {
  public:
    explicit PointTable(std::size_t corners) : m_slots(std::bit_ceil(2 * corners + 1), none) {}

    std::uint32_t indexOf(const base::Vec3d& point, std::vector<base::Vec3d>& points) {
        const std::size_t mask = m_slots.size() - 1;
        for (std::size_t slot = hash(point) & mask;; slot = (slot + 1) & mask) {
            if (m_slots[slot] == none) {
                m_slots[slot] = static_cast<std::uint32_t>(points.size());
                points.push_back(point);
            }
            if (same(points[m_slots[slot]], point))
                return m_slots[slot];
        }
    }

  private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static bool same(const base::Vec3d& a, const base::Vec3d& b) {
        for (std::size_t k = 0; k < 3; ++k) // bits, so that not-a-number finds itself
            if (std::bit_cast<std::uint64_t>(a[k]) != std::bit_cast<std::uint64_t>(b[k]))
                return false;
        return true;
    }
    static std::uint64_t hash(const base::Vec3d& p) {
        std::uint64_t out = 0;
        for (std::size_t k = 0; k < 3; ++k)
            out = base::mix(out ^ std::bit_cast<std::uint64_t>(p[k]));
        return out;
    }
    std::vector<std::uint32_t> m_slots;
};

} // namespace

Welded weldTriangles(std::span<const base::Vec3d> corners) {
    Welded out;
    PointTable table(corners.size());
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        std::uint32_t index[3];
        for (std::size_t k = 0; k < 3; ++k)
            index[k] = table.indexOf(corners[i + k] + base::Vec3d{}, out.points); // -0 + 0 = 0
        out.corners.insert(out.corners.end(), index, index + 3);
        out.normals.resize(out.points.size());
        const base::Vec3d normal = base::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        if (base::isFinite(normal))
            for (const std::uint32_t point : index)
                out.normals[point] += normal;
    }
    return out;
}

} // namespace io
