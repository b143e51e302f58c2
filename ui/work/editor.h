// The interface's side of the model: a thread of its own owns the document, runs commands and strokes on it in the
// order asked (model_worker.h), and publishes snapshots. The interface's thread never waits for it (ui/README 3).
//
//     interface                              model thread
//     run(command, then)  ---- TaskQueue -->  session::run            --> changed(), then(done)
//     beginStroke, addSample... (merged)     session::LiveStroke::add --> changed() after each slice of dabs
//     endStroke                              settle in slices while nothing else is asked for
//                                            finish, commit, journal  --> changed()
//     cancelStroke                           drops the LiveStroke     --> changed(), as if nothing had been
//
// Snapshots that arrive faster than they are shown replace each other.
#pragma once

#include "core/session/recover.h"
#include "ui/work/model_worker.h"

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <QElapsedTimer>
#include <QObject>
#include <thread>

namespace ui {

struct EditorOptions {
    bool keepJournal = true;
    std::filesystem::path journal; ///< empty: a file of this process in the state folder
    std::size_t historyBytes = std::size_t(1) << 30;
};

class Editor : public QObject {
    Q_OBJECT
  public:
    static constexpr qint64 patienceMs = 150; ///< what takes longer is long

    /// Throws base::Error where the journal cannot be written.
    explicit Editor(const EditorOptions& options = {}, QObject* parent = nullptr);
    /// Stops what is running and waits for it; what was queued is dropped. The journal stays unless discarded.
    ~Editor() override;

    // All of these on the interface's thread; they return at once.
    void run(nlohmann::json command, std::function<void(bool done)> then = {});
    /// The model as a left journal's last command had it, recorded anew in this editor's own journal.
    void recover(std::filesystem::path journal,
                 std::function<void(bool done, const session::Recovery& recovery)> then = {});
    /// Executes the lines of a session file; each is a step of history.
    void replay(std::filesystem::path session, std::function<void(bool done)> then = {});
    /// Writes all commands since the model was opened or made into a session file: what the journal holds.
    void saveSession(std::filesystem::path target, std::function<void(bool done)> then = {});
    /// Writes the document as a save would; it stays as changed as it was, under its own name.
    void saveCopy(std::filesystem::path path, std::function<void(bool done)> then = {});
    void runAside(SideTask task);
    /// The document as it is once all that was asked before is done, for whoever tries something on it.
    void copyDocument(std::shared_ptr<session::Document> into, std::function<void(bool done)> then);
    void beginStroke(const sculpt::StrokeSettings& settings);
    /// `input`: what Snapshot::input says once it is in the picture.
    void addSample(const sculpt::StrokeSample& sample, std::uint64_t input = 0);
    void endStroke();
    /// As if it had not been: what still waits of it is not done any more.
    void cancelStroke();
    /// Asks the first command that is not done, as far as told here, to stop, or not to begin; it then leaves the
    /// model as it was.
    void cancelWork();

    /// How much memory the steps back may hold; the oldest go first.
    void setHistoryBudget(std::size_t bytes);
    /// Nothing is journalled any more, and the file goes at once, or when what runs is done: the person has saved, or
    /// does not want to.
    void discardJournal();

    /// Something is running or waiting.
    bool busy() const { return m_waiting > 0; }
    /// Jobs that run or wait, a piece of a stroke being one.
    int waiting() const { return m_waiting; }
    /// A command or side task is among it, so that the model may soon be another.
    bool working() const { return m_commands > 0; }
    /// A stroke may begin: the model is not about to be another, and nothing that takes long is before it.
    bool ready() const { return m_replacing == 0 && (!working() || m_workingSince.elapsed() < patienceMs); }
    const Snapshot& snapshot() const { return m_snapshot; }
    /// Of a stroke's input: the last that the engine has taken, and the last of these that changed the model. The
    /// latter comes with a snapshot.
    std::uint64_t takenInput() const { return m_signals.takenInput; }
    std::uint64_t changingInput() const { return m_signals.changingInput; }
    /// Of the document's content once all that was asked is done. Blocks: for tests and reports.
    base::Hash128 hashWhenDone();

  Q_SIGNALS:
    void changed();                               ///< snapshot() is new
    void progressed(double share, QString doing); ///< of a running command, 0 to 1
    void told(QString message);                   ///< for the person: a sentence, or a line for each of several
    void failed(QString message);                 ///< what is wrong, where, what to do
    void recorded(QString line);                  ///< a command that changed the model; long ones are shortened
    void idled();                                 ///< nothing runs or waits any more

  private:
    WorkerReports reports();
    void work(); ///< the model thread
    void publish(Snapshot snapshot);
    void deliver();
    void finish(const std::function<void(bool)>& then, bool done, int commands);
    void push(Task task);
    void replace(CommandTask task);

    WorkerSignals m_signals;
    std::unique_ptr<ModelWorker> m_worker; ///< touched by the model thread alone
    TaskQueue m_queue;
    bool m_discardJournal = false;
    std::shared_ptr<std::atomic<bool>> m_strokeCancelled; ///< of the newest stroke
    Snapshot m_snapshot;
    int m_waiting = 0;
    int m_commands = 0; ///< of them, those that are not part of a stroke
    std::uint64_t m_commandsAsked = 0;
    int m_replacing = 0; ///< of these, those that start another model
    QElapsedTimer m_workingSince;
    std::mutex m_freshMutex;
    std::optional<Snapshot> m_fresh; ///< published, not yet delivered
    std::thread m_thread;            ///< last: it uses all of the above
};

} // namespace ui
