// One report of what was measured part by part. Internal to the room.
#pragma once

#include "core/reduce/verify.h"

#include <algorithm>
#include <cmath>

namespace reduce {

/// What several reports of different samples say together.
class ReportSum {
  public:
    void add(const Report& r, std::size_t samples) {
        const double n = double(samples);
        m_samples += n;
        m_out.count += r.count;
        m_rms += n * r.rms * r.rms, m_dense += n * r.denseRms * r.denseRms,
            m_surface += n * r.surfaceRms * r.surfaceRms;
        m_normals += n * r.normalsDeg * r.normalsDeg;
        m_out.p999 = std::max(m_out.p999, r.p999), m_out.max = std::max(m_out.max, r.max);
        m_out.surfaceMax = std::max(m_out.surfaceMax, r.surfaceMax);
        m_out.leastSupports = m_any ? std::min(m_out.leastSupports, r.leastSupports) : r.leastSupports;
        m_out.holes += r.holes, m_out.strays += r.strays;
        m_out.ellipsoids = m_out.ellipsoids || r.ellipsoids;
        m_any = true;
    }
    /// Surfels of the model themselves, which stand for so many samples.
    void keep(std::size_t count, std::size_t samples, double denseRms) {
        const double n = double(samples);
        m_out.count += count, m_samples += n;
        m_rms += n * denseRms * denseRms, m_dense += n * denseRms * denseRms;
    }
    void pick(std::size_t count) { m_out.picked += count; }
    Report report() const {
        Report out = m_out;
        const auto mean = [&](double sum) { return m_samples > 0 ? std::sqrt(sum / m_samples) : 0; };
        out.rms = mean(m_rms), out.denseRms = mean(m_dense), out.surfaceRms = mean(m_surface);
        out.normalsDeg = mean(m_normals);
        return out;
    }

  private:
    Report m_out;
    double m_samples = 0, m_rms = 0, m_dense = 0, m_surface = 0, m_normals = 0;
    bool m_any = false;
};

} // namespace reduce
