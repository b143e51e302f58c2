// The zeros of one cell's f along a ray (cells/README 4).
//
//     stretches     where on the ray surfels of a cell are so near that its surface can be there, and whether all of
//                   them face along or against the ray: then f has one zero at most
//     roots         of one stretch: by Newton's iteration where there is one at most, else by marching
#pragma once

#include "core/base/ray.h"
#include "core/cells/cell_source_float.h"

namespace cells {

/// A piece of a ray.
struct Stretch {
    std::uint32_t cell = 0, face = 0;
    double begin = 0, end = 0;
    double guess = 0;            ///< where the disc is crossed that passes closest to its centre
    double nearest = 0;          ///< distance to that centre, of the support
    double unit = 0;             ///< the least support of the surfels there
    double least = 1, most = -1; ///< of n.d over these surfels
    double first = 0, last = 0;  ///< the piece of it that can have zeros

    /// No surfel is seen at a flat angle, and all from the same side.
    bool monotone() const { return least > steep || most < -steep; }
    static constexpr double steep = 0.2;
};

/// By ascending `first`, within [tMin, tMax]. Stretches of one cell that touch are one, for each of its pieces.
std::vector<Stretch> stretches(const CellSurface& surface, const base::Rayd& ray, double tMin, double tMax);

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
