// The zeros of one cell's f along a ray (cells/README 4).
//
//     stretches     where on the ray surfels of a cell are so near that its surface can be there, and whether all of
//                   them face along or against the ray: then f has one zero at most             stretches.h
//     roots         of one stretch: by Newton's iteration where there is one at most, else by marching
#pragma once

#include "core/cells/cell_source_float.h"
#include "core/cells/stretches.h"

namespace cells {

/// Asks a CellSource or a CellSourcef.
template <class Source>
class CellRoots {
  public:
    CellRoots(Source& source, const base::Rayd& ray) : m_source(source), m_ray(ray) {}

    /// Appends the zeros, ascending; evaluations() grows.
    void find(const Stretch& stretch, std::vector<double>& out);
    int evaluations() const { return m_evaluations; }

  private:
    struct Sample {
        double t = 0, f = 0;
        bool valid = false;
    };
    Sample sample(double t);
    /// What rounding leaves of a place on the ray.
    double rounding(double t) const { return Source::rounding * std::max(std::abs(t), length(m_source.position())); }
    bool newton(const Stretch& stretch, double& t);
    void march(const Stretch& stretch, std::vector<double>& out);
    /// Of a change of sign; nothing where f jumps there.
    void refine(Sample a, Sample b, double unit, std::vector<double>& out);

    Source& m_source;
    base::Rayd m_ray;
    std::uint32_t m_cell = 0;
    int m_evaluations = 0;
};

extern template class CellRoots<CellSource>;
extern template class CellRoots<CellSourcef>;

} // namespace cells
