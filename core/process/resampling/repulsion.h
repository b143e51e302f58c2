// What the neighbours of a sample push it by along the surface, in lanes:
//
//     sum over j of (reach_j - |d_j|) t_j / |t_j|,    t_j = d_j - n (n.d_j),  of those with |d_j| < reach_j
//
// in the order in which they were added, to the bit. Internal to resample; one thread.
#pragma once

#include "core/base/vec.h"

namespace process {

class Repulsion {
  public:
    void begin(const base::Vec3f& normal) { m_normal = normal, m_sum = {}, m_count = 0; }
    /// `d`: from the neighbour to the sample.
    void add(const base::Vec3f& d, float reach) {
        if (m_count == capacity)
            flush();
        m_d[0][m_count] = d.x, m_d[1][m_count] = d.y, m_d[2][m_count] = d.z;
        m_reach[m_count++] = reach;
    }
    base::Vec3f end() {
        flush();
        return m_sum;
    }

  private:
    static constexpr int capacity = 16;
    void flush();

    alignas(64) float m_d[3][capacity] = {};
    float m_reach[capacity] = {};
    int m_count = 0;
    base::Vec3f m_normal, m_sum;
};

} // namespace process
