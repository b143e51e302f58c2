// Where along a ray a cell's f can be zero: looked for in the order of the ray, as far as is asked (cells/README 4).
//
//     StretchFinder finder(surface);
//     finder.start(ray)
//     finder.look(from, to, ahead)      what begins up to some supports beyond the first disc from there on
//     finder.found(), finder.end()      its stretches; nothing up to `end` is left out
#pragma once

#include "core/base/ray.h"
#include "core/cells/cell_surface.h"

namespace cells {

/// A piece of a ray.
struct Stretch {
    std::uint32_t cell = 0, face = 0;
    double begin = 0, end = 0;
    double guess = 0;            ///< where the disc is crossed that passes closest to its centre
    double nearest = 0;          ///< squared distance to that centre, of the support
    double unit = 0;             ///< the least support of the surfels there
    double least = 1, most = -1; ///< of n.d over these surfels
    double first = 0, last = 0;  ///< the piece of it that can have zeros

    /// No surfel is seen at a flat angle, and all from the same side.
    bool monotone() const { return least > steep || most < -steep; }
    static constexpr double steep = 0.2;
};

class StretchFinder {
  public:
    explicit StretchFinder(const CellSurface& surface);

    /// REQUIRES: a unit direction.
    void start(const base::Rayd& ray);
    /// Of [from, to] the part up to `ahead` supports beyond the first disc that the ray crosses there; all of it where
    /// there is none.
    void look(double from, double to, double ahead);

    /// By ascending `first`, within [from, end]. Stretches of one cell that touch are one, for each of its pieces.
    const std::vector<Stretch>& found() const { return m_found; }
    double end() const { return m_end; }
    /// Where to look from next: so little before `end` that no zero falls between.
    double resume() const { return m_end - 1e-3 * m_unit; }
    /// Was there a cluster that other cells are near to?
    bool mixed() const { return m_mixed; }

  private:
    /// The chord of a ball about a surfel in which the surface that it tells of can be.
    struct Chord {
        std::uint32_t cell, face;
        double begin, end, guess;
        double level;   ///< the ray is slope t - level above the surfel's plane
        double inverse; ///< of the slope
        float nearest, slope, unit;
        base::Vec3f normal;
    };
    class Bracket;
    /// What becomes one of chords of a cell.
    struct Whole {
        Stretch stretch;
        base::Box3f normals;
        double least = 0, most = 0; ///< where the ray meets their planes
        double unit = 0;            ///< the largest support

        bool touches(const Whole& o) const;
        void unite(const Whole& o);
    };

    void note(const surfel::SurfelBlock& block, int cluster, double enter, double from, double to);
    void unite(const Chord& chord);
    void uniteAll();
    /// Its pieces, to the stretches found.
    void append(const Whole& whole);

    const CellSurface* m_surface;
    base::Rayd m_ray;
    base::Rayf m_rounded;
    double m_crossing = 0; ///< of the first disc
    double m_unit = 0;     ///< its support
    double m_end = 0;
    bool m_mixed = false;
    std::vector<Chord> m_chords;
    std::vector<const Chord*> m_about; ///< those of a bracket
    std::vector<Whole> m_whole;
    std::vector<Stretch> m_found;
};

/// All of [tMin, tMax].
std::vector<Stretch> stretches(const CellSurface& surface, const base::Rayd& ray, double tMin, double tMax);

} // namespace cells
