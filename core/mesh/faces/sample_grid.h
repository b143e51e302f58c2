// Samples by where they are, for searches within a radius that is known before.
#pragma once

#include "core/base/cells.h"
#include "core/surfel/surfel.h"

namespace mesh {

class SampleGrid {
  public:
    SampleGrid(std::span<const surfel::Surfel> samples, double radius) : m_samples(samples), m_radius(radius) {
        for (std::uint32_t i = 0; i < samples.size(); ++i)
            m_cells.at(cellOf(at(i))).push_back(i);
    }

    base::Vec3d at(std::uint32_t i) const { return base::cast<double>(m_samples[i].position); }
    /// fn(i, distanceSq) for the samples closer to p than the radius.
    template <class Fn>
    void forAround(const base::Vec3d& p, const Fn& fn) const {
        base::forCellsAround(cellOf(p), [&](const base::Cell& cell) {
            if (const std::vector<std::uint32_t>* there = m_cells.find(cell))
                for (const std::uint32_t i : *there)
                    if (const double distanceSq = base::distanceSq(at(i), p); distanceSq < m_radius * m_radius)
                        fn(i, distanceSq);
        });
    }

  private:
    base::Cell cellOf(const base::Vec3d& p) const { return base::cellOf(p, base::Vec3d(), 1 / m_radius); }

    std::span<const surfel::Surfel> m_samples;
    double m_radius;
    base::CellMap<std::vector<std::uint32_t>> m_cells;
};

} // namespace mesh
