// The document and what belongs to it, on the model thread: performs the editor's tasks one by one and publishes what
// has become of the model. Made and ended on any thread; the rest is the model thread's alone.
//
// A stroke that has ended is *settling*: its last resampling is done in slices while nothing else is asked for, then it
// becomes a step of history. Whatever else is asked for first does the rest at once, but undo, which lays the stroke
// aside as it is: the model is as before at once, and redo goes on with it. So nothing of this shows in the record.
#pragma once

#include "core/sculpt/stroke/stroke_pacer.h"
#include "core/session/journal.h"
#include "core/session/live_stroke.h"
#include "ui/work/command_cancel.h"
#include "ui/work/snapshot.h"
#include "ui/work/task_queue.h"

#include <atomic>
#include <map>
#include <memory>
#include <QString>

namespace ui {

/// What the interface's thread asks of work that is running, and how far a stroke's input has come.
struct WorkerSignals {
    CommandCancel cancel;
    std::atomic<std::uint64_t> takenInput = 0, changingInput = 0; ///< see Editor
};

/// What the worker tells; called on the model thread.
struct WorkerReports {
    std::function<void(Snapshot)> published;
    std::function<void(double share, QString doing)> progressed;
    std::function<void(QString)> told, failed;
    std::function<void(QString)> recorded; ///< a command that changed the model, as a line of a session
    /// A task is done; `commands`: 1 unless it is part of a stroke.
    std::function<void(std::function<void(bool)> then, bool done, int commands)> finished;
};

class ModelWorker {
  public:
    /// `signals` outlives it. Without a journal nothing is recorded.
    ModelWorker(WorkerSignals& signals, WorkerReports reports, std::unique_ptr<session::Journal> journal);

    void setHistoryBudget(std::size_t bytes) { m_document.setHistoryBudget(bytes); }
    void perform(Task& task);
    bool settling() const { return m_settling != nullptr; }
    /// REQUIRES: settling().
    void settleSlice();
    /// After the thread has ended.
    void discardJournal();
    /// On the model thread.
    const session::Document& document() const { return m_document; }

  private:
    /// A stroke with what it refers to.
    struct OpenStroke {
        session::Context context;
        std::shared_ptr<std::atomic<bool>> cancelled; ///< asked for by the interface's thread
        std::optional<session::LiveStroke> stroke;
    };
    void perform(CommandTask& task);
    void perform(SideTask& task);
    void perform(BeginStroke& task);
    void perform(AddSamples& task);
    void perform(EndStroke&);
    void perform(CancelStroke&);

    session::Context context();
    base::Progress progress();
    /// False where `work` has thrown, which is reported.
    template <class Work>
    bool guarded(const Work& work);
    void publish(Snapshot snapshot);
    void publishDocument();
    void publishStroke();
    bool strokeWanted() const;
    /// `last`: the pointer event that brought the sample, if it is the last of it; else 0.
    void addSlice(const sculpt::StrokeSample& sample, std::uint64_t last);
    bool layAside(); ///< the settling stroke, for redo; false where there is none to undo
    bool takeUp();   ///< what was laid aside; false where nothing was
    void endSettling();
    void endAll(); ///< every stroke there is becomes history
    bool finish(std::unique_ptr<OpenStroke> stroke);
    void publishSettling();
    void tell(const std::vector<std::string>& messages);

    WorkerSignals& m_signals;
    WorkerReports m_reports;
    session::Document m_document;
    session::ShownScene m_beside; ///< what is seen beside the active model
    struct Reference {
        surface::Surface surface; ///< as the model was when opened, made or last saved
        base::Vec3d origin;       ///< that its stored coordinates are counted from
    };
    std::map<std::uint32_t, Reference> m_references; ///< by model
    std::unique_ptr<session::Journal> m_journal;
    std::unique_ptr<OpenStroke> m_stroke;   ///< being drawn
    std::unique_ptr<OpenStroke> m_settling; ///< ended; none is drawn meanwhile
    std::unique_ptr<OpenStroke> m_undone;   ///< laid aside; none is drawn or settles meanwhile
    sculpt::StrokePacer m_pacer;
    std::uint64_t m_command = 0; ///< how many commands and side tasks have been begun
    std::uint64_t m_models = 0;  ///< as Snapshot::models
    double m_dabSeconds = 0;
    std::uint64_t m_input = 0; ///< the last in a stroke
    Snapshot m_shown;          ///< the last published
};

} // namespace ui
