// Where the planes of symmetry meet the surface: curves traced in the background between two strokes, since during one
// they would take the processors that it needs. Interface's thread only.
#pragma once

#include "ui/overlay/symmetry_overlay.h"
#include "ui/work/editor.h"
#include "ui/work/section_tracer.h"

#include <memory>

namespace ui {

class SymmetryCurves : public QObject {
    Q_OBJECT
  public:
    /// The editor outlives it.
    explicit SymmetryCurves(const Editor& editor, QObject* parent = nullptr);
    ~SymmetryCurves() override;

    /// Asks for the curves of these planes on the model as it is now, unless they are there or on their way.
    void trace(const sculpt::MirrorPlanes& planes);
    /// By axis; those that are being traced anew stay until the new ones are there.
    const AxisCurves& curves() const { return m_curves; }

  Q_SIGNALS:
    void traced(); ///< curves() are new

  private:
    void receive(const TracedSections& found);

    const Editor& m_editor;
    AxisCurves m_curves;
    const void* m_root = nullptr; ///< of the version last asked for
    render::ClipPlanes m_planes;
    std::unique_ptr<SectionTracer> m_tracer; ///< last: its thread ends first
};

} // namespace ui
