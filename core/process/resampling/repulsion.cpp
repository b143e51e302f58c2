#include "core/process/resampling/repulsion.h"

#include "core/base/clones.h"

#include <limits>

namespace process {

/// Makes pushes of the differences, all of them.
POINTCLAY_CLONES
static void push(float* __restrict dx, float* __restrict dy, float* __restrict dz, const float* __restrict reach,
                 int count, const base::Vec3f& n) {
    const float nx = n.x, ny = n.y, nz = n.z;
    for (int k = 0; k < count; ++k) {
        const float x = dx[k], y = dy[k], z = dz[k];
        const float up = nx * x + ny * y + nz * z, l = std::sqrt(x * x + y * y + z * z);
        const float tx = x - nx * up, ty = y - ny * up, tz = z - nz * up;
        const float t = std::sqrt(tx * tx + ty * ty + tz * tz);
        const bool pushes = l < reach[k] && t > 0 && t < std::numeric_limits<float>::infinity();
        const float by = pushes ? reach[k] - l : 0.0f, root = pushes ? t : 1.0f;
        dx[k] = pushes ? tx / root * by : 0.0f;
        dy[k] = pushes ? ty / root * by : 0.0f;
        dz[k] = pushes ? tz / root * by : 0.0f;
    }
}

void Repulsion::flush() {
    push(m_d[0], m_d[1], m_d[2], m_reach, capacity, m_normal);
    for (int k = 0; k < m_count; ++k)
        m_sum += {m_d[0][k], m_d[1][k], m_d[2][k]};
    m_count = 0;
}

} // namespace process
