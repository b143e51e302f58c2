#include "ui/work/model_worker.h"

#include "ui/work/post.h"

#include <chrono>

namespace ui {

using Clock = std::chrono::steady_clock;

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
    m_signals.cancel = m_signals.closing.load();
    try {
        work();
        return true;
    } catch (const base::Cancelled&) {
        m_reports.told("Cancelled; the model is unchanged.");
    } catch (const std::bad_alloc&) {
        m_reports.failed("There is not enough memory for this; the model is unchanged.");
    } catch (const std::exception& error) {
        m_reports.failed(QString::fromStdString(error.what()));
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
        m_reports.progressed(share, textOf(doing));
    };
    return {report, &m_signals.cancel};
}

session::Context ModelWorker::context() {
    return {m_document, {}, progress(), {}, 0, {}, m_journal.get()};
}

void ModelWorker::tell(const std::vector<std::string>& messages) {
    for (const auto& message : messages)
        m_reports.told(textOf(message));
}

// --- publishing ---

void ModelWorker::publish(Snapshot snapshot) {
    snapshot.dabSeconds = m_dabSeconds;
    snapshot.input = m_input;
    m_shown = snapshot;
    m_reports.published(std::move(snapshot));
}

void ModelWorker::publishDocument() {
    Snapshot out = snapshotOf(m_document);
    out.reference = out.modified ? m_shown.reference : out.surface;
    out.models = m_models;
    publish(std::move(out));
}

void ModelWorker::publishStroke() {
    Snapshot out = m_shown;
    out.surface = m_stroke->surface();
    out.surfels = out.surface.tree().size();
    publish(std::move(out));
}

// --- commands ---

void ModelWorker::perform(CommandTask& task) {
    finishStroke(); // one that is still open: a command comes after it
    const tree::SurfelTree before = m_document.surface().tree();
    session::Context used = context();
    const bool done = guarded([&] { task.work(used); });
    tell(used.messages);
    if (!m_document.canUndo() && !m_document.canRedo() && !(m_document.surface().tree() == before))
        ++m_models;
    publishDocument();
    m_reports.finished(std::move(task.then), done, 1);
}

void ModelWorker::perform(SideTask& task) {
    const bool done = guarded([&] {
        const base::Progress steps = progress();
        steps.report(0, task.what);
        task.work(m_document.surface(), steps);
    });
    m_reports.finished(std::move(task.then), done, 1);
}

// --- strokes ---

void ModelWorker::dropStroke() {
    m_stroke.reset();
    m_strokeContext.reset();
}

bool ModelWorker::finishStroke() {
    if (!m_stroke)
        return false;
    guarded([&] { m_stroke->finish(); });
    tell(m_strokeContext->messages);
    dropStroke();
    return true;
}

void ModelWorker::perform(BeginStroke& task) {
    dropStroke();
    m_strokeContext.emplace(context());
    m_strokeCancelled = task.cancelled;
    m_strokeContext->progress = {{}, m_strokeCancelled.get()};
    m_pacer = sculpt::StrokePacer(task.settings);
    guarded([&] { m_stroke.emplace(*m_strokeContext, task.settings); });
    m_reports.finished({}, true, 0);
}

bool ModelWorker::strokeWanted() const {
    return m_stroke && !*m_strokeCancelled && !m_signals.closing;
}

/// In slices: between them the picture is published and a cancelled stroke ends.
void ModelWorker::perform(AddSamples& task) {
    if (strokeWanted()) {
        const std::vector<sculpt::StrokeSample> samples = m_pacer.paced(task.samples, m_stroke->depth());
        for (std::size_t i = 0; i < samples.size() && strokeWanted(); ++i)
            addSlice(samples[i], i + 1 == samples.size() ? task.input : 0);
        m_signals.takenInput = task.input;
    }
    m_reports.finished({}, true, 0);
}

void ModelWorker::addSlice(const sculpt::StrokeSample& sample, std::uint64_t last) {
    const auto start = Clock::now();
    const int before = m_stroke->dabs();
    bool changed = false;
    if (!guarded([&] { changed = m_stroke->add(sample); })) {
        dropStroke();
        return publishDocument();
    }
    m_pacer.took(secondsSince(start), m_stroke->dabs() - before);
    if (!changed)
        return;
    if (last != 0)
        m_signals.changingInput = m_input = last;
    m_dabSeconds = m_pacer.dabSeconds();
    publishStroke();
}

void ModelWorker::perform(EndStroke&) {
    if (finishStroke())
        publishDocument();
    m_reports.finished({}, true, 0);
}

void ModelWorker::perform(CancelStroke&) {
    if (m_stroke) {
        dropStroke();
        publishDocument();
    }
    m_reports.finished({}, true, 0);
}

} // namespace ui
