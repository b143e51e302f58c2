// Opening, saving, exporting, recovering: the questions to the person around the commands that do it.
#pragma once

#include "ui/editor.h"
#include "ui/settings.h"
#include "ui/view_controller.h"

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
    void exportImage();
    void writeImage(const std::filesystem::path& path);
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

    QMainWindow& m_window;
    Editor& m_editor;
    Settings& m_settings;
    ViewController& m_controller;
    QString m_failure; ///< the last that a command told
};

} // namespace ui
