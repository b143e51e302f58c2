// A stroke while it is drawn: what the window does between press and release. It sculpts what `stroke` in a session
// would, shows every version on the way, and becomes one step of history and one journal line when it is done.
//
//     press:    LiveStroke stroke(context, settings);
//     move:     if (stroke.add(sample)) show(stroke.surface());
//     release:  while (!stroke.settle()) {}     in slices, should something else be due
//               stroke.finish();
//
// Dropping it without `finish` takes the stroke back. Where the context's progress is cancelled, base::Cancelled leaves
// `add` and `finish` between two dabs, and dropping is all that is left. REQUIRES: the document stays as it is
// meanwhile.
#pragma once

#include "core/sculpt/stroke/stroke.h"
#include "core/session/command.h"

namespace session {

class LiveStroke {
  public:
    /// Throws base::Error for settings out of range, for a stamp that is no image, and where no model is open.
    LiveStroke(Context& context, sculpt::StrokeSettings settings);

    /// Returns true where at least one dab was made: then `surface()` is a new version.
    bool add(const sculpt::StrokeSample& sample);
    /// A slice of the last resampling, which `finish` does not do again; true when nothing is left of it.
    bool settle();
    /// Last resampling, history, journal. A stroke that never met the model leaves no trace. Returns whether it did.
    bool finish();
    /// Has it changed anything so far?
    bool changed() const { return !(m_stroke.surface().tree() == m_start.tree()); }
    const char* label() const; ///< as history shows it
    /// The complete command `stroke` of what was added so far.
    nlohmann::json line() const;

    /// Of what is shown of the model.
    const surface::Surface& surface() const { return m_stroke.surface(); }
    int dabs() const { return m_stroke.dabs(); }
    /// Of the first contact along its ray, once there is one.
    std::optional<float> depth() const { return m_stroke.depth(); }

  private:
    surface::Surface withItsEdges();
    void tellOfStep(const tree::SurfelTree& done); ///< beside hidden parts

    Context& m_context;
    sculpt::StrokeSettings m_settings;
    surface::Surface m_start; ///< what is shown of the model: what is hidden is not there for tools
    sculpt::Stroke m_stroke;
    std::vector<sculpt::StrokeSample> m_samples;
};

} // namespace session
