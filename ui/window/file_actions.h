// Opening, saving, exporting, recovering: the questions to the person around the commands that do it.
#pragma once

#include "ui/viewport/view_controller.h"
#include "ui/window/image_dialog.h"
#include "ui/window/settings.h"
#include "ui/work/editor.h"

class QMainWindow;

namespace ui {

/// Dialog filters from io::formatTable(): all readable ones in one entry, then each by its label.
QString openFilter();
/// One entry for each writable format; the first is the native one.
QString saveFilter();

class FileActions : public QObject {
    Q_OBJECT
  public:
    /// All outlive it.
    FileActions(QMainWindow& window, Editor& editor, Settings& settings, ViewController& controller);

    void make(const std::string& sample);
    void open();
    void open(const std::filesystem::path& path);
    /// A MODEL as the command line names it: a file, or sample:NAME[:COUNT[:SEED]].
    void openArgument(const std::string& model);
    void save(std::function<void()> then = {});
    void saveAs(std::function<void()> then = {});
    /// Asks what it is to be and where to, then writes it.
    void exportImage();
    /// The view as it is, at the viewport's size.
    void writeImage(const std::filesystem::path& path);
    /// Drawn and written in the background, with progress; Esc stops it. The file is there complete or not at all.
    void writeImage(const std::filesystem::path& path, const ImageChoice& choice);
    /// Asks about journals that a crash has left; true where one is being recovered.
    bool offerRecovery();
    /// Runs `next` at once, after saving, or never: as the person decides about unsaved work.
    void unlessUnsaved(std::function<void()> next);

  Q_SIGNALS:
    void recentChanged();

  private:
    void load(const std::filesystem::path& path);
    void write(const std::filesystem::path& path, std::function<void()> then);
    void recover(const std::filesystem::path& journal);
    void remember(const std::filesystem::path& path);
    void showFailure(const QString& title);
    QString folder() const;
    void askImagePath(const ImageChoice& choice);

    QMainWindow& m_window;
    Editor& m_editor;
    Settings& m_settings;
    ViewController& m_controller;
    ImageChoice m_image; ///< the last one exported; of no size before
    QString m_failure;   ///< the last that a command told
};

} // namespace ui
