// Keeps the sampling of a stroke: notes what each dab moved, says when that is enough to resample, and does it.
//
// What counts is how far the dabs have stretched or squeezed the sampling since it was last seen to (stretches.h):
// where it is beyond 1.8 or 0.5 resampling is due, and done wherever it has come a part of the way there (how these
// were found: sculpt/README 7). At the end of the stroke all that it touched is looked at. The target spacing s is
// taken where the stroke first touches.
#pragma once

#include "core/sculpt/stretches.h"
#include "core/sculpt/tool.h"

namespace sculpt {

/// Surfels come or go, so that blocks and slots may get other numbers.
bool restructures(const tree::Edit& edit);

class Sampling {
  public:
    /// Call with the first contact. Until then, and on models too small to have a spacing, nothing is ever due.
    /// `graded`: the target is what the supports at each place are made for, where the definition lets them vary.
    void start(const surface::Surface& surface, const base::Vec3f& contact, bool graded = false);
    bool started() const { return m_spacing > 0; }
    float spacing() const { return m_spacing; }

    /// After a dab: `before` is the version it was applied to.
    void note(const tree::SurfelTree& before, const tree::Edit& edit, const Dab& dab);
    bool due() const { return !m_range.within(dueBeyond); }
    /// Resamples where it is due. REQUIRES: the surface after the last dab noted.
    surface::Surface resampleDue(const surface::Surface& surface);
    bool pending() const { return !m_balls.empty(); }
    /// Resamples all that the noted dabs touched and forgets them. REQUIRES: pending().
    surface::Surface resample(const surface::Surface& surface);

  private:
    struct Ball {
        base::Vec3f centre;
        float radius;
    };
    static constexpr StretchRange dueBeyond{0.5f, 1.8f};
    void add(Ball ball);
    tree::Selection touched(const tree::SurfelTree& tree) const;
    surface::Surface resampled(const surface::Surface& surface, const tree::Selection& touched) const;

    float m_spacing = 0;
    bool m_graded = false;
    Stretches m_stretches;
    StretchRange m_range;      ///< of the blocks
    std::vector<Ball> m_balls; ///< that hold all that was touched
};

} // namespace sculpt
