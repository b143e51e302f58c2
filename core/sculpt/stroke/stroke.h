// A stroke: samples in, versions out. Mouse, tablet, script, test and replay all build the same thing.
//
//     StrokeSample -> Stabiliser -> Method (stroke_methods.h) -> Dabs (stroke_dabs.h) -> tool -> next version
//
// Symmetry: every image of a ray has its own exact contact, found on the same version as the others'.
//
// The result depends on the settings and the samples alone, never on time or on how many samples came at once, so that
// a recorded stroke replays bit for bit. The caller shows `surface()` whenever it likes; dropping the Stroke undoes it.
//
//     Stroke stroke(surface, settings);
//     for each sample: stroke.add(sample);      contacts, spacing, symmetry, dabs, resampling
//     stroke.finish();                          the last resampling
//     use stroke.surface()
#pragma once

#include "core/layers/stack.h"
#include "core/sculpt/brush_stamp.h"
#include "core/sculpt/stroke/stroke_sample.h"
#include "core/sculpt/stroke/stroke_settings.h"

#include <atomic>
#include <optional>

namespace sculpt {

class Stroke {
  public:
    /// `origin`: what Symmetry mirrors at, relative to which positions are stored (io::FileModel::origin). `stamp`: the
    /// image that settings.stamp names. `cancel`: where not null, base::Cancelled leaves `add` and `finish` before the
    /// next dab and the next contact once it is set; the stroke is then good for nothing but to be dropped. Outlives
    /// the stroke. Checks the settings.
    Stroke(surface::Surface start, StrokeSettings settings, base::Vec3d origin = {},
           std::shared_ptr<const BrushStamp> stamp = {}, const std::atomic<bool>* cancel = nullptr);
    ~Stroke();
    /// The model has layers: what tools do goes into the active one (layers/README 3). Before the first sample.
    void onLayers(std::shared_ptr<const layers::Stack> stack);
    Stroke(Stroke&&) noexcept;
    Stroke& operator=(Stroke&&) noexcept;

    /// Returns true where `surface()` is a new version. Throws base::Error for samples that are not finite or rays
    /// without direction.
    bool add(const StrokeSample& sample);
    /// The last resampling. Adding more samples afterwards is allowed and continues the stroke.
    void finish();
    /// A slice of it, some thousand surfels; true when nothing is left. What comes out does not depend on who calls.
    bool finishSlice();

    const surface::Surface& surface() const;
    /// Of the first contact along its ray, once there is one.
    std::optional<float> depth() const;
    /// Places where the tool was applied in this version; images do not count.
    int dabs() const;
    /// Seconds that each of them took, images and resampling included.
    std::span<const double> dabSeconds() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace sculpt
