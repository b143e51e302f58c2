// Keeps the sampling of a stroke: notes what each dab moved, says when that is enough to resample, and does it.
//
// Resampling is due after 4 s of travel or a stretch of 1.5 since the last one (RESAMPLING 1 and 3: every fifth dab of
// a spacing is better than every one, only once at the end destroys the model), and at the end of the stroke. The
// target spacing s is taken where the stroke first touches.
#pragma once

#include "core/sculpt/tool.h"
#include "core/tree/selection.h"

namespace sculpt {

/// Surfels come or go, so that blocks and slots may get other numbers.
bool restructures(const tree::Edit& edit);

class Sampling {
  public:
    /// Call with the first contact. Until then, and on models too small to have a spacing, nothing is ever due.
    void start(const surface::Surface& surface, const base::Vec3f& contact);
    bool started() const { return m_spacing > 0; }
    float spacing() const { return m_spacing; }

    /// After a dab: `before` is the version it was applied to.
    void note(const tree::SurfelTree& before, const tree::Edit& edit, const Dab& dab);
    bool due() const;
    bool pending() const { return !m_balls.empty(); }
    /// Resamples what the noted dabs touched and forgets them. REQUIRES: pending().
    surface::Surface resample(const surface::Surface& surface);

  private:
    struct Ball {
        base::Vec3f centre;
        float radius;
    };
    void add(Ball ball);
    tree::Selection touched(const tree::SurfelTree& tree) const;

    float m_spacing = 0;
    float m_travel = 0;  ///< sum of the dabs' largest displacements
    float m_stretch = 1; ///< product of the dabs' largest stretches
    std::vector<Ball> m_balls;
};

} // namespace sculpt
