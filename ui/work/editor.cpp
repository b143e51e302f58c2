#include "ui/work/editor.h"

#include "core/session/journal.h"
#include "core/session/live_stroke.h"
#include "core/session/recover.h"
#include "ui/work/post.h"
#include "ui/work/stroke_pacer.h"

#include <algorithm>
#include <chrono>
#include <future>

namespace ui {

using Clock = std::chrono::steady_clock;

/// The document and what belongs to it, on the model thread.
struct Editor::Model {
    explicit Model(Editor& owner) : editor(owner) {}

    Editor& editor;
    session::Document document;
    std::unique_ptr<session::Journal> journal;
    std::optional<session::Context> strokeContext; ///< what `stroke` refers to
    std::optional<session::LiveStroke> stroke;
    StrokePacer pacer;
    std::uint64_t models = 0;
    double dabSeconds = 0;
    std::uint64_t input = 0; ///< the last in a stroke
    Snapshot shown;          ///< the last published

    void perform(CommandTask& task);
    void perform(SideTask& task);
    void perform(BeginStroke& task);
    void perform(AddSamples& task);
    void perform(EndStroke&);
    void perform(CancelStroke&);

    session::Context context();
    base::Progress progress();
    template <class Work>
    bool guarded(const Work& work);
    void publish(Snapshot snapshot);
    void publishDocument();
    void publishStroke();
    template <class Wanted>
    void addPiece(const std::vector<sculpt::StrokeSample>& samples, std::uint64_t last, const Wanted& wanted);
    void addSlice(const sculpt::StrokeSample& sample, std::uint64_t last);
    bool finishStroke(); ///< false where there is none
    void dropStroke();
    void tell(const std::vector<std::string>& messages);
};

template <class Work>
bool Editor::Model::guarded(const Work& work) {
    const auto report = [this](auto signal, const QString& text) {
        Editor* target = &editor;
        post(target, [=] { std::invoke(signal, target, text); });
    };
    editor.m_cancel = editor.m_closing.load();
    try {
        work();
        return true;
    } catch (const base::Cancelled&) {
        report(&Editor::told, "Cancelled; the model is as it was.");
    } catch (const std::bad_alloc&) {
        report(&Editor::failed, "There is not enough memory for this; the model is as it was.");
    } catch (const std::exception& error) {
        report(&Editor::failed, QString::fromStdString(error.what()));
    }
    return false;
}

base::Progress Editor::Model::progress() {
    auto last = std::make_shared<Clock::time_point>(Clock::now() - std::chrono::hours(1));
    const auto report = [target = &editor, last](double share, std::string_view doing) {
        if (Clock::now() - *last < std::chrono::milliseconds(40))
            return;
        *last = Clock::now();
        post(target, [target, share, text = textOf(doing)] { Q_EMIT target->progressed(share, text); });
    };
    return {report, &editor.m_cancel};
}

session::Context Editor::Model::context() {
    return {document, {}, progress(), {}, 0, {}, journal.get()};
}

void Editor::Model::tell(const std::vector<std::string>& messages) {
    for (const auto& message : messages) {
        post(&editor, [target = &editor, text = textOf(message)] { Q_EMIT target->told(text); });
    }
}

void Editor::Model::publish(Snapshot snapshot) {
    shown = snapshot;
    const std::lock_guard lock(editor.m_freshMutex);
    const bool underWay = editor.m_fresh.has_value();
    editor.m_fresh = std::move(snapshot);
    if (!underWay)
        post(&editor, [target = &editor] { target->deliver(); });
}

void Editor::Model::publishDocument() {
    Snapshot out = snapshotOf(document);
    out.reference = out.modified ? shown.reference : out.surface;
    out.models = models;
    out.dabSeconds = dabSeconds;
    out.input = input;
    publish(std::move(out));
}

void Editor::Model::publishStroke() {
    Snapshot out = shown;
    out.surface = stroke->surface();
    out.surfels = out.surface.tree().size();
    out.dabSeconds = dabSeconds;
    out.input = input;
    publish(std::move(out));
}

bool Editor::Model::finishStroke() {
    if (!stroke)
        return false;
    guarded([&] { stroke->finish(); });
    tell(strokeContext->messages);
    dropStroke();
    return true;
}

void Editor::Model::dropStroke() {
    stroke.reset();
    strokeContext.reset();
}

// --- the tasks ---

void Editor::Model::perform(CommandTask& task) {
    finishStroke(); // one that is still open: a command comes after it
    const tree::SurfelTree before = document.surface().tree();
    session::Context used = context();
    const bool done = guarded([&] { task.work(used); });
    tell(used.messages);
    if (!document.canUndo() && !document.canRedo() && !(document.surface().tree() == before))
        ++models;
    publishDocument();
    editor.finished(std::move(task.then), done, 1);
}

void Editor::Model::perform(SideTask& task) {
    const bool done = guarded([&] {
        const base::Progress steps = progress();
        steps.report(0, task.what);
        task.work(document.surface(), steps);
    });
    editor.finished(std::move(task.then), done, 1);
}

void Editor::Model::perform(BeginStroke& task) {
    dropStroke();
    strokeContext.emplace(context());
    pacer = StrokePacer(task.settings);
    guarded([&] { stroke.emplace(*strokeContext, task.settings); });
    editor.finished({}, true, 0);
}

/// In slices: between them the picture is published and a cancelled stroke ends.
void Editor::Model::perform(AddSamples& task) {
    const auto wanted = [this] { return stroke && editor.m_strokeCancels == 0 && !editor.m_closing; };
    if (wanted())
        addPiece(pacer.paced(task.samples, stroke->depth()), task.input, wanted);
    editor.finished({}, true, 0);
}

template <class Wanted>
void Editor::Model::addPiece(const std::vector<sculpt::StrokeSample>& samples, std::uint64_t last,
                             const Wanted& wanted) {
    for (std::size_t i = 0; i < samples.size() && wanted(); ++i)
        addSlice(samples[i], i + 1 == samples.size() ? last : 0);
    editor.m_takenInput = last;
}

void Editor::Model::addSlice(const sculpt::StrokeSample& sample, std::uint64_t last) {
    const auto start = Clock::now();
    const int before = stroke->dabs();
    bool changed = false;
    if (!guarded([&] { changed = stroke->add(sample); }))
        return dropStroke();
    pacer.took(std::chrono::duration<double>(Clock::now() - start).count(), stroke->dabs() - before);
    if (!changed)
        return;
    if (last != 0)
        editor.m_changingInput = input = last;
    dabSeconds = pacer.dabSeconds();
    publishStroke();
}

void Editor::Model::perform(EndStroke&) {
    if (finishStroke())
        publishDocument();
    editor.finished({}, true, 0);
}

void Editor::Model::perform(CancelStroke&) {
    --editor.m_strokeCancels;
    if (stroke) {
        dropStroke();
        publishDocument();
    }
    editor.finished({}, true, 0);
}

// --- the two threads ---

Editor::Editor(const EditorOptions& options, QObject* parent) : QObject(parent), m_model(new Model(*this)) {
    if (options.keepJournal)
        m_model->journal = std::make_unique<session::Journal>(options.journal);
    m_thread = std::thread([this] { work(); });
}

Editor::~Editor() {
    m_closing = true;
    m_cancel = true;
    m_queue.close();
    m_thread.join();
    if (m_discardJournal && m_model->journal)
        m_model->journal->discard();
}

void Editor::work() {
    while (std::optional<Task> task = m_queue.pop())
        std::visit([this](auto& kind) { m_model->perform(kind); }, *task);
}

void Editor::push(Task task) {
    ++m_waiting;
    const bool command = std::holds_alternative<CommandTask>(task) || std::holds_alternative<SideTask>(task);
    if (command && m_commands++ == 0)
        m_workingSince.start();
    m_waiting -= static_cast<int>(m_queue.push(std::move(task)));
}

void Editor::finished(std::function<void(bool)> then, bool done, int commands) {
    const auto onInterface = [this, then = std::move(then), done, commands] {
        --m_waiting;
        m_commands -= commands;
        deliver();
        if (then)
            then(done);
        if (m_waiting == 0)
            Q_EMIT idled();
    };
    post(this, onInterface);
}

void Editor::deliver() {
    {
        const std::lock_guard lock(m_freshMutex);
        if (!m_fresh)
            return;
        m_snapshot = std::move(*m_fresh);
        m_fresh.reset();
    }
    Q_EMIT changed();
}

void Editor::run(nlohmann::json command, std::function<void(bool)> then) {
    bool replaces = false;
    for (const auto& row : session::commandTable())
        replaces |= row.startsModel && command.value("op", "") == row.op;
    const auto work = [command = std::move(command)](session::Context& context) { session::run(context, command); };
    CommandTask task{work, std::move(then)};
    if (replaces)
        replace(std::move(task));
    else
        push(std::move(task));
}

void Editor::recover(std::filesystem::path journal, std::function<void(bool)> then) {
    const auto work = [journal = std::move(journal)](session::Context& context) { session::recover(journal, context); };
    replace({work, std::move(then)});
}

void Editor::replace(CommandTask task) {
    ++m_replacing;
    task.then = [this, then = std::move(task.then)](bool done) {
        --m_replacing;
        if (then)
            then(done);
    };
    push(std::move(task));
}

void Editor::runAside(SideTask task) {
    push(std::move(task));
}

void Editor::beginStroke(const sculpt::StrokeSettings& settings) {
    push(BeginStroke{settings});
}

void Editor::addSample(const sculpt::StrokeSample& sample, std::uint64_t input) {
    push(AddSamples{{sample}, input});
}

void Editor::endStroke() {
    push(EndStroke{});
}

void Editor::cancelStroke() {
    ++m_strokeCancels;
    push(CancelStroke{});
}

base::Hash128 Editor::hashWhenDone() {
    std::promise<base::Hash128> answer;
    push(SideTask{"Hashing",
                  [&](const surface::Surface&, const base::Progress&) { answer.set_value(m_model->document.hash()); },
                  {}});
    return answer.get_future().get();
}

} // namespace ui
