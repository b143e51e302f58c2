#include "core/mesh/faces/face_scraps.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <array>
#include <cmath>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

namespace {

/// A triangle by its longest side, of which slices are cut across, and these along it. Halves of longest sides would be
/// ever thinner: those of a sliver grow in number by more than its length.
class Slices {
  public:
    Slices(const std::array<Vec3d, 3>& p, double area) : m_p(p), m_area(area) {
        for (std::size_t i = 1; i < 3; ++i)
            if (distanceSq(p[i], p[(i + 1) % 3]) > distanceSq(p[m_k], p[(m_k + 1) % 3]))
                m_k = i;
        m_length = distance(p[m_k], p[(m_k + 1) % 3]);
    }

    /// Scraps of such a size, nearly.
    double count(double size) const {
        return m_length <= size ? 1 : (m_length / size + 1) * (m_area / m_length / size + 1);
    }

    void cut(double size, std::uint32_t triangle, std::vector<Scrap>& out) const {
        if (m_length <= size) {
            out.push_back({base::cast<float>((m_p[0] + m_p[1] + m_p[2]) / 3), static_cast<float>(m_area), triangle});
            return;
        }
        const Vec3d a = m_p[m_k], along = m_p[(m_k + 1) % 3] - a, c = m_p[(m_k + 2) % 3];
        const double foot = std::clamp(dot(c - a, along) / (m_length * m_length), 0.0, 1.0);
        const Vec3d across = c - (a + along * foot);
        const auto slices = static_cast<std::size_t>(std::ceil(m_length / size));
        const auto middle = [&](std::size_t i) { return (static_cast<double>(i) + 0.5) / static_cast<double>(slices); };
        const auto height = [&](double x) { return x < foot ? x / foot : (1 - x) / (1 - foot); }; // 1 over the foot
        double heights = 0;
        for (std::size_t i = 0; i < slices; ++i)
            heights += height(middle(i));
        for (std::size_t i = 0; i < slices; ++i) {
            const double x = middle(i), h = height(x);
            const double parts = std::max(1.0, std::ceil(2 * m_area / m_length * h / size));
            for (double k = 0.5; k < parts; ++k)
                out.push_back({base::cast<float>(a + along * x + across * (h * k / parts)),
                               static_cast<float>(m_area * h / heights / parts), triangle});
        }
    }

  private:
    std::array<Vec3d, 3> m_p;
    double m_area, m_length = 0;
    std::size_t m_k = 0; ///< the longest side begins there
};

} // namespace

std::vector<Scrap> scrapsOf(const FaceTopology& topology, std::span<const Vec3f> positions,
                            std::span<const double> sizes, std::size_t most) {
    const auto slicesOf = [&](std::size_t t) {
        std::array<Vec3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = base::cast<double>(positions[topology.triangles[t][k]]);
        return Slices(p, topology.areas[t]);
    };
    const std::size_t all = topology.triangles.size();
    std::vector<double> counts(all);
    base::parallelFor(all, 1024, [&](std::size_t t) {
        if (topology.areas[t] > 0)
            counts[t] = slicesOf(t).count(sizes[t]);
    });
    double limit = static_cast<double>(most); // of one triangle
    const auto total = [&] {
        double sum = 0;
        for (const double each : counts)
            sum += std::min(each, limit);
        return sum;
    };
    while (limit > 1 && total() > static_cast<double>(most) + static_cast<double>(all))
        limit /= 2;
    constexpr std::size_t grain = 1024;
    std::vector<std::vector<Scrap>> found(base::chunkCount(all, grain));
    base::parallelChunks(all, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t t = begin; t < end; ++t) {
            base::CancelScope::check();
            if (!(topology.areas[t] > 0))
                continue;
            const Slices slices = slicesOf(t);
            double size = sizes[t];
            while (slices.count(size) > std::max(1.0, limit))
                size *= 1.25;
            slices.cut(size, static_cast<std::uint32_t>(t), found[chunk]);
        }
    });
    std::vector<Scrap> out;
    for (std::vector<Scrap>& each : found) {
        out.insert(out.end(), each.begin(), each.end());
        each = {};
    }
    return out;
}

} // namespace mesh
