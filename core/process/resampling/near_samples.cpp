#include "core/process/resampling/near_samples.h"

#include "core/base/clones.h"

namespace process {

/// Samples that are looked around at once, at most.
constexpr std::size_t together = 16;
/// Of the cells that one sample looks through, so many times as many pay for two, four, eight and sixteen.
constexpr double fairGrowth = 2;

static base::Box3f around(const SampleSet& set, std::span<const std::uint32_t> samples, float reach) {
    base::Box3f out;
    for (const std::uint32_t i : samples)
        out.extend(base::Box3f{set.position[i], set.position[i]}.inflated(reach * set.target[i]));
    return out;
}

void NearSamples::gather(std::span<const std::uint32_t> samples, float reach) {
    m_box = around(m_set, samples.first(1), reach);
    double cells = m_set.grid.cellsIn(m_box);
    for (std::size_t count = 2; count <= std::min(together, samples.size()); count *= 2) {
        const base::Box3f larger = around(m_set, samples.first(count), reach);
        const double more = m_set.grid.cellsIn(larger);
        if (more > fairGrowth * cells)
            break;
        m_box = larger, cells = more;
    }
    fill();
}

void NearSamples::fill() {
    m_x.clear(), m_y.clear(), m_z.clear(), m_index.clear(), m_normal.clear();
    m_set.grid.forIn(m_box, [&](const PointGrid::Entry& e) {
        if (m_set.is(e.index, Gone) || !m_box.contains(e.position))
            return;
        m_x.push_back(e.position.x), m_y.push_back(e.position.y), m_z.push_back(e.position.z);
        m_index.push_back(e.index);
        m_normal.push_back(m_set.normal[e.index]);
    });
    m_sq.resize(m_x.size());
    m_picked.resize(m_x.size() + 1);
}

bool NearSamples::covers(const base::Vec3f& p, float radius) const {
    const base::Vec3f reach{radius, radius, radius};
    return m_box.contains(p - reach) && m_box.contains(p + reach);
}

POINTCLAY_CLONES
static void squares(const float* x, const float* y, const float* z, std::size_t count, const base::Vec3f& p,
                    float* sq) {
    for (std::size_t k = 0; k < count; ++k) {
        const float dx = x[k] - p.x, dy = y[k] - p.y, dz = z[k] - p.z;
        sq[k] = dx * dx + dy * dy + dz * dz;
    }
}

std::size_t NearSamples::pick(const base::Vec3f& p, float radiusSq) {
    squares(m_x.data(), m_y.data(), m_z.data(), m_x.size(), p, m_sq.data());
    std::size_t count = 0;
    for (std::size_t k = 0; k < m_sq.size(); ++k) {
        m_picked[count] = static_cast<std::uint32_t>(k);
        count += m_sq[k] < radiusSq ? 1 : 0;
    }
    return count;
}

} // namespace process
