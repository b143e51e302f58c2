// The place that copying tools copy from: chosen on the model, forgotten with it. Interface's thread only.
#pragma once

#include "ui/work/editor.h"

namespace ui {

class CloneSource : public QObject {
    Q_OBJECT
  public:
    /// The editor outlives it.
    explicit CloneSource(const Editor& editor, QObject* parent = nullptr);

    /// Stored coordinates; nothing before a place is chosen.
    const std::optional<base::Vec3d>& place() const { return m_place; }
    void choose(const std::optional<base::Vec3d>& place);
    /// Tells a stroke that begins at `contact` where to copy from. REQUIRES: a place is chosen.
    void addTo(sculpt::StrokeSettings& settings, const base::Vec3d& contact) const;

  Q_SIGNALS:
    void changed(QString place); ///< in the file's coordinates; empty: none

  private:
    const Editor& m_editor;
    std::optional<base::Vec3d> m_place;
};

} // namespace ui
