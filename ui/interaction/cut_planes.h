// The planes that cut the model open, and the curves in which they meet its surface, traced in the background so that
// they follow a stroke. Interface's thread only.
#pragma once

#include "core/render/overlay/section_lines.h"
#include "ui/view/cuts.h"
#include "ui/work/editor.h"
#include "ui/work/section_tracer.h"

namespace ui {

class CutPlanes : public QObject {
    Q_OBJECT
  public:
    /// The editor outlives it.
    explicit CutPlanes(const Editor& editor, QObject* parent = nullptr);
    ~CutPlanes() override;

    const Cuts& cuts() const { return m_cuts; }
    void set(const Cuts& cuts);
    /// For another model: all planes off, through its middle.
    void reset();
    /// Turns the free plane across a direction (unit, towards the eye), through the middle of the model.
    void turnFreePlane(const base::Vec3d& towardsEye);

    /// Of the planes as they are now; empty until they are traced.
    const render::SectionCurves& sections() const { return m_sections; }
    /// Asks for the curves of the model as it is now, unless they are there or on their way.
    void trace();

  Q_SIGNALS:
    void moved();                 ///< by `set`: the picture is another one
    void changed();               ///< by `reset` or `turnFreePlane`: for what shows the planes' settings
    void traced();                ///< sections() are new
    void failed(QString message); ///< tracing stopped, and why

  private:
    void receive(TracedSections found);

    const Editor& m_editor;
    Cuts m_cuts;
    render::SectionCurves m_sections;
    const void* m_tracedRoot = nullptr; ///< of the version last asked to be traced
    render::ClipPlanes m_tracedPlanes;
    std::unique_ptr<SectionTracer> m_tracer; ///< last: its thread ends first
};

} // namespace ui
