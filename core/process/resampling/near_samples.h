// What stands around a few samples that lie together, gathered once for all of them: in arrays, from which each picks
// what is near it, in lanes. Internal to resample; one thread.
#pragma once

#include "core/base/box.h"
#include "core/process/resampling/resample_set.h"

namespace process {

class NearSamples {
  public:
    explicit NearSamples(const SampleSet& set) : m_set(set) {}

    /// All that is not gone within `reach` of the first of these samples, and of as many more as share most of that;
    /// `reach` in units of their targets.
    void gather(std::span<const std::uint32_t> samples, float reach);
    /// Is all within `radius` of p gathered?
    bool covers(const base::Vec3f& p, float radius) const;
    /// fn(sample, normal) for those closer than `radius` to p, in the order of the grid. REQUIRES: covers(p, radius).
    template <class Fn>
    void forWithin(const base::Vec3f& p, float radius, const Fn& fn) {
        const std::size_t count = pick(p, radius * radius);
        for (std::size_t k = 0; k < count; ++k)
            fn(m_index[m_picked[k]], m_normal[m_picked[k]]);
    }

  private:
    void fill();
    std::size_t pick(const base::Vec3f& p, float radiusSq);

    const SampleSet& m_set;
    base::Box3f m_box;
    std::vector<float> m_x, m_y, m_z, m_sq;
    std::vector<std::uint32_t> m_index, m_picked;
    std::vector<base::Vec3f> m_normal;
};

} // namespace process
