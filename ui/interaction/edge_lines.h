// The edges that stay sharp as lines over the picture, traced in the background whenever the model rests. Interface's
// thread only.
#pragma once

#include "core/render/overlay/section_lines.h"
#include "ui/work/editor.h"
#include "ui/work/latest_worker.h"

#include <memory>

namespace ui {

class EdgeLines : public QObject {
    Q_OBJECT
  public:
    /// The editor outlives it.
    explicit EdgeLines(const Editor& editor, QObject* parent = nullptr);
    ~EdgeLines() override;

    void show(bool on);
    bool shown() const { return m_shown; }
    /// Of the model as it was traced last; empty while they are not shown.
    const std::vector<surface::SectionCurve>& curves() const { return m_curves; }
    /// Asks for those of the model as it is now, unless they are there or on their way.
    void trace();

  Q_SIGNALS:
    void traced();                ///< curves() are new
    void failed(QString message); ///< tracing stopped, and why

  private:
    using Curves = std::vector<surface::SectionCurve>;

    const Editor& m_editor;
    bool m_shown = false;
    Curves m_curves;
    const void* m_tracedRoot = nullptr;                       ///< of the version last asked to be traced
    std::unique_ptr<LatestWorker<surface::Surface>> m_worker; ///< last: its thread ends first
};

} // namespace ui
