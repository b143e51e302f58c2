// Pictures of the view as files: asks what they should be and where they go, draws them in the background. Interface's
// thread only.
#pragma once

#include "ui/interaction/sculpt_view.h"
#include "ui/window/failure_box.h"
#include "ui/window/image_dialog.h"

namespace ui {

class ImageExport : public QObject {
    Q_OBJECT
  public:
    /// All outlive it.
    ImageExport(QMainWindow& window, Editor& editor, const Settings& settings, SculptView& view);

    /// Asks for size, kind and file, then writes it.
    void ask();
    /// The view as it is, at the viewport's size.
    void write(const std::filesystem::path& path);
    /// With progress; Esc stops it. The file is there complete or not at all.
    void write(const std::filesystem::path& path, const ImageChoice& choice);

  private:
    void askPath(const ImageChoice& choice);
    ImageChoice asShown() const; ///< at the viewport's size

    QMainWindow& m_window;
    Editor& m_editor;
    const Settings& m_settings;
    SculptView& m_view;
    FailureBox m_failure;
    ImageChoice m_last; ///< chosen; of no size before
};

} // namespace ui
