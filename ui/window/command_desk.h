// Where dialogs of commands lie open beside the picture: one at a time, and the view turns, zooms and sculpts
// meanwhile. It shows in the picture what would come of the command, picks the places that the dialog wants, and runs
// the command when it is wanted. Interface's thread only.
#pragma once

#include "ui/work/command_preview.h"

#include <QPointer>
#include <QTimer>

namespace ui {

class CommandDialog;
class MainWindow;

class CommandDesk : public QObject {
    Q_OBJECT
  public:
    static constexpr int pauseMs = 300; ///< between the last edit and the preview

    explicit CommandDesk(MainWindow& window);
    /// Another dialog that is open is closed.
    void open(const session::CommandRow& row);
    CommandDialog* dialog() const { return m_dialog; }
    CommandPreview& preview() { return m_preview; }

  private:
    void connectDialog();
    void place();
    void edited();
    void askPreview();
    void show(const Previewed& found);
    void showFound();
    void pick(const QString& field);
    void endPick();
    void finish(bool accepted);
    void followModel();
    void beginHandles();
    void enterPlacement();
    void showPlacement();

    MainWindow& m_window;
    CommandPreview m_preview;
    QTimer m_pause;
    QPointer<CommandDialog> m_dialog;
    bool m_picking = false;
    bool m_trying = false, m_again = false; ///< a preview is being made; something has changed since
    bool m_entering = false;                ///< what handles say into the fields
    std::optional<Previewed> m_found;       ///< the last preview that was made of it as it is
    tree::SurfelTree m_model;               ///< that the dialog is about
};

} // namespace ui
