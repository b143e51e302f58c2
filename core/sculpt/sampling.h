// Keeps the sampling of a stroke: notes what each dab moved, says when that is enough to resample, and does it.
//
// What counts is how far the dabs have stretched or squeezed the sampling since it was last seen to (stretches.h):
// where it is beyond 1.8 or 0.5 resampling is due, and done for surfels beyond 1.2 or 0.75 (how these were found:
// sculpt/README 7), the most strained first where they are many. At the end of the stroke those, and what was resampled
// before, are looked at once more. Others keep every bit. The target is the spacing that was there before the stroke
// (kept_spacing.h).
#pragma once

#include "core/cells/measured_labels.h"
#include "core/layers/stack.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/kept_spacing.h"
#include "core/sculpt/stretches.h"
#include "core/sculpt/tool.h"

#include <functional>

namespace sculpt {

/// Surfels come or go, so that blocks and slots may get other numbers.
bool restructures(const tree::Edit& edit);

class Sampling {
  public:
    /// Call with the first contact. Until then, and on models too small to have a spacing, nothing is ever due.
    /// `graded`: everything touched is made even, with the spacing that the supports at each place are made for, where
    /// the definition lets them vary. `stack`: what the model's layers hold is carried along; null: it has none.
    void start(const surface::Surface& surface, const base::Vec3f& contact, bool graded = false,
               std::shared_ptr<const layers::Stack> stack = {});
    bool started() const { return m_spacing > 0; }
    /// At the first contact.
    float spacing() const { return m_spacing; }

    /// Before a dab samples under the brush have given way to finer ones on the same surface: their spacing is to be
    /// kept.
    void refined(const tree::SurfelTree& before, const surface::Surface& after, const base::Vec3f& centre,
                 float radius);
    /// After a dab: `before` is the version it was applied to.
    void note(const tree::SurfelTree& before, const tree::Edit& edit, const Dab& dab);
    /// The same for tools that make the sampling that they want: of these only crumbs are taken away.
    void noteCount(const tree::Edit& edit, const Dab& dab);
    bool due() const { return !m_range.within(dueBeyond) || m_waiting > atOnce; }
    /// Resamples where it is due. REQUIRES: the surface after the last dab noted.
    surface::Surface resampleDue(const surface::Surface& surface);
    bool pending() const { return !m_balls.empty(); }
    /// Resamples what the noted dabs have stretched, takes crumbs away, measures creases anew (cells/README 1.6), and
    /// forgets the dabs.
    surface::Surface resample(surface::Surface surface);
    /// A slice of that: until no more is pending(). REQUIRES: pending(); the surface after the last dab or slice.
    surface::Surface resampleSlice(const surface::Surface& surface);

  private:
    struct Ball {
        base::Vec3f centre;
        float radius;
    };
    static constexpr StretchRange dueBeyond{0.5f, 1.8f};
    /// Where resampling is due somewhere, surfels beyond these are done with it.
    static constexpr StretchRange doneBeyond{0.75f, 1.2f};
    /// About so many surfels are resampled at once, the most strained first, so that no dab of a wide brush takes long.
    static constexpr std::size_t atOnce = 6000;
    /// Of an end: the order of its slices.
    enum class Ending { Open, Asked, Crumbs };
    void add(Ball ball);
    tree::Selection touched(const tree::SurfelTree& tree, float margin = 0) const;
    /// Under a stroke what is resampled has been drawn apart: its samples still lie where they were meant to, its
    /// surface no longer does, and nothing is fitted to it. At the end it is, against erosion (process/README 4.10).
    enum class When { During, AtTheEnd };
    tree::SurfelTree resampled(const surface::Surface& surface, const tree::Selection& which,
                               const process::ResampleOptions& options) const;
    surface::Surface evened(surface::Surface surface, When when) const;
    bool resampleSome(surface::Surface& surface, std::size_t count, When when);
    surface::Surface resampleClass(const surface::Surface& surface, const tree::Selection& taken, When when);
    void askAtTheEnd(const surface::Surface& surface);
    using Which = std::function<Stretches::Slots(const Stretches::Tracked&)>;
    void measureTracked(const Which& which);
    void askForDrift(const surface::Surface& surface);
    struct Candidate;
    std::vector<Candidate> driftCandidates(const surface::Surface& surface) const;
    bool drifted(const Stretches::Tracked& each, const std::vector<StretchRange>& ranges) const;
    void measureAround(const tree::SurfelTree& tree);
    surface::Surface withoutCrumbs(const surface::Surface& surface);
    surface::Surface withLabels(const surface::Surface& surface, std::size_t firstBall, cells::Partners partners);
    tree::Selection mayBeCrumbs(const tree::SurfelTree& tree) const;
    LocalSpacing measuredOf(const Stretches::Tracked& each, int slot) const;
    float targetOf(const Stretches::Tracked& each, int slot) const;
    float targetOf(const surfel::SurfelBlock& block, int slot) const;

    float m_spacing = 0;
    bool m_graded = false, m_counts = false;
    KeptSpacing m_kept;
    Stretches m_stretches;
    StretchRange m_range;      ///< of the blocks
    std::size_t m_waiting = 0; ///< surfels in blocks that are nearly due
    Ending m_ending = Ending::Open;
    std::vector<Ball> m_balls;  ///< that hold all that was touched
    std::size_t m_labelled = 0; ///< in those before, signs are as surfels lay when resampling was due
    std::shared_ptr<const layers::Stack> m_layers;
};

} // namespace sculpt
