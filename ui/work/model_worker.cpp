#include "ui/work/model_worker.h"

#include "core/process/curve_tube.h"
#include "core/session/json_text.h"
#include "ui/words/words.h"
#include "ui/work/post.h"

#include <chrono>
#include <nlohmann/json.hpp>

namespace ui {

using Clock = std::chrono::steady_clock;

static constexpr std::size_t longestLine = 400; ///< that a console shows, in characters

static double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

ModelWorker::ModelWorker(WorkerSignals& signals, WorkerReports reports, std::unique_ptr<session::Journal> journal)
    : m_signals(signals), m_reports(std::move(reports)), m_journal(std::move(journal)) {}

void ModelWorker::perform(Task& task) {
    std::visit([this](auto& kind) { perform(kind); }, task);
}

void ModelWorker::discardJournal() {
    if (m_journal)
        m_journal->discard();
}

template <class Work>
bool ModelWorker::guarded(const Work& work) {
    const tree::SurfelTree before = m_document.surface().tree();
    try {
        work();
        return true;
    } catch (const base::Cancelled&) {
        m_reports.told(m_document.surface().tree() == before ? QObject::tr("Cancelled; the model is unchanged.")
                                                             : QObject::tr("Cancelled; what was done before stays."));
    } catch (const std::bad_alloc&) {
        m_reports.failed(QObject::tr("There is not enough memory for this; the model is unchanged."));
    } catch (const std::exception& error) {
        m_reports.failed(spokenMessage(error.what()));
    }
    return false;
}

base::Progress ModelWorker::progress() {
    static constexpr auto pause = std::chrono::milliseconds(40); // between two reports
    auto last = std::make_shared<Clock::time_point>(Clock::now() - std::chrono::hours(1));
    const auto report = [this, last](double share, std::string_view doing) {
        if (Clock::now() - *last < pause)
            return;
        *last = Clock::now();
        m_reports.progressed(share, spoken(doing, "progress"));
    };
    return {report, &m_signals.cancel.flag()};
}

session::Context ModelWorker::context() {
    session::Context out{m_document, {}, progress(), {}, 0, {}, m_journal.get()};
    out.recorded = [this](const nlohmann::json& complete) {
        if (session::command(complete["op"].get_ref<const std::string&>()).startsModel) {
            ++m_models; // in the middle of a session, too
            m_references.clear();
        }
        m_reports.recorded(QString::fromStdString(session::shortly(complete, longestLine)));
    };
    return out;
}

void ModelWorker::tell(const std::vector<std::string>& messages) {
    QStringList spoken;
    for (const auto& message : messages)
        spoken << spokenMessage(message);
    if (!spoken.isEmpty())
        m_reports.told(spoken.join('\n'));
}

// --- publishing ---

void ModelWorker::publish(Snapshot snapshot) {
    snapshot.dabSeconds = m_dabSeconds;
    snapshot.input = m_input;
    m_shown = snapshot;
    m_reports.published(std::move(snapshot));
}

void ModelWorker::publishDocument() {
    Snapshot out = snapshotOf(m_document, m_beside);
    const base::Vec3d& origin = m_document.provenance().origin;
    Reference& reference = m_references.try_emplace(out.model, Reference{out.surface, origin}).first->second;
    if (!out.modified || reference.origin != origin) // moved so far that float32 cannot hold both places
        reference = {out.surface, origin};
    out.reference = reference.surface;
    out.models = m_models;
    if (m_undone) {
        out.canRedo = true;
        out.redoLabel = m_undone->stroke->label();
        out.future.insert(out.future.begin(), out.redoLabel);
    }
    publish(std::move(out));
}

void ModelWorker::publishStroke() {
    Snapshot out = m_shown;
    out.surface = m_stroke->stroke->surface();
    out.whole = m_beside.whole(out.surface.tree());
    out.surfels += out.surface.tree().size() - m_shown.surface.tree().size(); // of all, hidden ones too
    publish(std::move(out));
}

/// The version that a settling stroke has made counts as a step of history already.
void ModelWorker::publishSettling() {
    Snapshot out = m_shown;
    out.surface = m_settling->stroke->surface();
    out.whole = m_beside.whole(out.surface.tree());
    out.surfels += out.surface.tree().size() - m_shown.surface.tree().size(); // of all, hidden ones too
    if (m_settling->stroke->changed()) {
        out.modified = out.canUndo = true;
        out.undoLabel = m_settling->stroke->label();
        out.canRedo = false;
        out.past.push_back(out.undoLabel);
        out.future.clear();
    }
    publish(std::move(out));
}

// --- commands ---

void ModelWorker::perform(CommandTask& task) {
    ++m_command;
    const bool aside = (task.kind == CommandKind::Undo && layAside()) || (task.kind == CommandKind::Redo && takeUp());
    if (aside)
        return m_reports.finished(std::move(task.then), true, 1);
    endAll(); // a command comes after them
    const tree::SurfelTree before = m_document.surface().tree();
    const std::uint64_t models = m_models;
    session::Context used = context();
    m_signals.cancel.begin(m_command);
    const bool done = guarded([&] { task.work(used); });
    tell(used.messages);
    if (m_models == models && !m_document.canUndo() && !m_document.canRedo() &&
        !(m_document.surface().tree() == before))
        ++m_models;
    publishDocument();
    m_reports.finished(std::move(task.then), done, 1);
}

void ModelWorker::perform(SideTask& task) {
    ++m_command;
    endSettling();
    m_signals.cancel.begin(m_command);
    const bool done = guarded([&] {
        const base::Progress steps = progress();
        steps.report(0, task.what);
        task.work(m_document.surface(), steps);
    });
    m_reports.finished(std::move(task.then), done, 1);
}

// --- strokes ---

bool ModelWorker::finish(std::unique_ptr<OpenStroke> open) {
    if (!open)
        return false;
    guarded([&] { open->stroke->finish(); });
    tell(open->context.messages);
    return true;
}

bool ModelWorker::layAside() {
    if (!m_settling || !m_settling->stroke->changed())
        return false;
    m_undone = std::move(m_settling);
    publishDocument();
    m_reports.finished({}, true, 0); // its end
    return true;
}

bool ModelWorker::takeUp() {
    if (!m_undone)
        return false;
    finish(std::move(m_undone));
    publishDocument();
    return true;
}

void ModelWorker::endSettling() {
    if (!finish(std::move(m_settling)))
        return;
    publishDocument();
    m_reports.finished({}, true, 0);
}

void ModelWorker::endAll() {
    endSettling();
    if (finish(std::move(m_stroke)))
        publishDocument();
    if (finish(std::move(m_undone)))
        guarded([&] {
            session::Context used = context();
            used.progress = {}; // what is cancelled is a command
            session::run(used, {{"op", "undo"}});
        });
}

void ModelWorker::settleSlice() {
    bool done = false;
    if (guarded([&] { done = m_settling->stroke->settle(); }) && !done)
        return;
    if (done)
        finish(std::move(m_settling));
    m_settling.reset();
    publishDocument();
    m_reports.finished({}, true, 0);
}

void ModelWorker::perform(BeginStroke& task) {
    m_undone.reset(); // as a new step of history drops what could be done again
    endAll();
    auto open = std::make_unique<OpenStroke>(OpenStroke{context(), task.cancelled, {}});
    open->context.progress = {{}, task.cancelled.get()};
    m_pacer = sculpt::StrokePacer(task.settings);
    if (guarded([&] { open->stroke.emplace(open->context, task.settings); }))
        m_stroke = std::move(open);
    m_reports.finished({}, true, 0);
}

bool ModelWorker::strokeWanted() const {
    return m_stroke && !*m_stroke->cancelled && !m_signals.cancel.closed();
}

/// In slices: between them the picture is published and a cancelled stroke ends.
void ModelWorker::perform(AddSamples& task) {
    if (strokeWanted()) {
        const std::vector<sculpt::StrokeSample> samples = m_pacer.paced(task.samples, m_stroke->stroke->depth());
        for (std::size_t i = 0; i < samples.size() && strokeWanted(); ++i)
            addSlice(samples[i], i + 1 == samples.size() ? task.input : 0);
        m_signals.takenInput = task.input;
    }
    m_reports.finished({}, true, 0);
}

void ModelWorker::addSlice(const sculpt::StrokeSample& sample, std::uint64_t last) {
    const auto start = Clock::now();
    session::LiveStroke& stroke = *m_stroke->stroke;
    const int before = stroke.dabs();
    bool changed = false;
    if (!guarded([&] { changed = stroke.add(sample); })) {
        m_stroke.reset();
        return publishDocument();
    }
    m_pacer.took(secondsSince(start), stroke.dabs() - before);
    if (!changed)
        return;
    if (last != 0)
        m_signals.changingInput = m_input = last;
    m_dabSeconds = m_pacer.dabSeconds();
    publishStroke();
}

/// That its end is done is told when it is history.
void ModelWorker::perform(EndStroke&) {
    if (!m_stroke)
        return m_reports.finished({}, true, 0);
    m_settling = std::move(m_stroke);
    publishSettling();
}

void ModelWorker::perform(CancelStroke&) {
    if (m_stroke) {
        m_stroke.reset();
        publishDocument();
    }
    m_reports.finished({}, true, 0);
}

} // namespace ui
