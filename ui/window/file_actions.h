// Making, opening, saving and recovering models: the questions to the person around the commands that do it.
// Interface's thread only.
#pragma once

#include "ui/settings/settings.h"
#include "ui/window/failure_box.h"
#include "ui/work/editor.h"

namespace ui {

/// "bust.ply" and "bust_007.ply" are followed by "bust_002.ply" and "bust_008.ply", or the next that is not there.
std::filesystem::path nextVersion(const std::filesystem::path& path);

class FileActions : public QObject {
    Q_OBJECT
  public:
    /// All outlive it.
    FileActions(QMainWindow& window, Editor& editor, Settings& settings);

    void make(const std::string& sample);
    void open();
    /// Asks as `openWith` where the file does not tell which of its columns are x, y and z.
    void open(const std::filesystem::path& path);
    /// Asks for a file, unless one is given, and all that the command `open` takes.
    void openWith(const std::filesystem::path& path = {});
    /// Asks for a file, beginning in a folder.
    void openIn(const std::filesystem::path& folder);
    /// A MODEL as the command line names it: a file, or sample:NAME[:COUNT[:SEED]].
    void openArgument(const std::string& model);
    /// Asks for a file whose models come into the scene.
    void add();
    void save(std::function<void()> then = {});
    void saveAs(std::function<void()> then = {});
    /// Asks for a name; the model stays what it is, under the name that it has.
    void saveCopy();
    void saveCopy(const std::filesystem::path& path);
    /// Under the next name that is free (`nextVersion`); asks for one where there is none yet.
    void saveVersion();
    /// Executes the lines of a session that the person chooses; most begin with another model.
    void runSession();
    void runSession(const std::filesystem::path& session);
    /// All that was done since the model was opened or made, as a session.
    void saveSession();
    /// Asks about journals that a crash has left; true where one is being recovered.
    bool offerRecovery();
    /// Runs `next` at once, after saving, or never: as the person decides about unsaved work.
    void unlessUnsaved(std::function<void()> next);

  Q_SIGNALS:
    void recentChanged();
    /// Another model is on its way, "Opening bunny.ply"; it has come, or has not.
    void began(QString what);
    void ended();

  private:
    void load(const std::filesystem::path& path, nlohmann::json command = {});
    /// Where to save it, asked of the person; empty: nowhere.
    std::filesystem::path askTarget(const QString& title);
    void write(const std::filesystem::path& path, std::function<void()> then);
    void recover(const session::LeftJournal& journal);
    QString sessionFilter() const { return tr("Sessions (*.jsonl)"); }
    void remember(const std::filesystem::path& path);
    QString folder() const;

    QMainWindow& m_window;
    Editor& m_editor;
    Settings& m_settings;
    FailureBox m_failure;
};

} // namespace ui
