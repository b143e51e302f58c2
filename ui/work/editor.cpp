#include "ui/work/editor.h"

#include "core/base/error.h"
#include "core/session/journal.h"
#include "core/session/session_file.h"
#include "ui/work/post.h"

#include <future>

namespace ui {

// --- the two threads ---

Editor::Editor(const EditorOptions& options, QObject* parent) : QObject(parent) {
    std::unique_ptr<session::Journal> journal;
    if (options.keepJournal)
        journal = std::make_unique<session::Journal>(options.journal);
    m_worker = std::make_unique<ModelWorker>(m_signals, reports(), std::move(journal));
    m_worker->setHistoryBudget(options.historyBytes);
    m_thread = std::thread([this] { work(); });
}

Editor::~Editor() {
    m_signals.cancel.close();
    if (m_strokeCancelled)
        *m_strokeCancelled = true;
    m_queue.close();
    m_thread.join();
    if (m_discardJournal)
        m_worker->discardJournal();
}

void Editor::work() {
    for (;;) {
        while (m_worker->settling() && m_queue.idle())
            m_worker->settleSlice();
        std::optional<Task> task = m_queue.pop();
        if (!task)
            return;
        m_worker->perform(*task);
    }
}

/// Posts to the interface's thread what the worker tells.
WorkerReports Editor::reports() {
    WorkerReports out;
    out.published = [this](Snapshot snapshot) { publish(std::move(snapshot)); };
    out.progressed = [this](double share, const QString& doing) {
        post(this, [this, share, doing] { Q_EMIT progressed(share, doing); });
    };
    out.told = [this](const QString& message) { post(this, [this, message] { Q_EMIT told(message); }); };
    out.recorded = [this](const QString& line) { post(this, [this, line] { Q_EMIT recorded(line); }); };
    out.failed = [this](const QString& message) { post(this, [this, message] { Q_EMIT failed(message); }); };
    out.finished = [this](std::function<void(bool)> then, bool done, int commands) {
        post(this, [this, then = std::move(then), done, commands] { finish(then, done, commands); });
    };
    return out;
}

/// On the model thread. A snapshot that waits to be delivered is replaced.
void Editor::publish(Snapshot snapshot) {
    const std::lock_guard lock(m_freshMutex);
    const bool underWay = m_fresh.has_value();
    m_fresh = std::move(snapshot);
    if (!underWay)
        post(this, [this] { deliver(); });
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

void Editor::finish(const std::function<void(bool)>& then, bool done, int commands) {
    --m_waiting;
    m_commands -= commands;
    deliver();
    if (then)
        then(done);
    if (m_waiting == 0)
        Q_EMIT idled();
}

void Editor::discardJournal() {
    m_discardJournal = true; // should the queue not come to it
    push(CommandTask{[](session::Context& context) {
                         if (context.journal)
                             context.journal->discard();
                     },
                     {}});
}

void Editor::setHistoryBudget(std::size_t bytes) {
    push(CommandTask{[bytes](session::Context& context) { context.document.setHistoryBudget(bytes); }, {}});
}

// --- asking ---

void Editor::push(Task task) {
    ++m_waiting;
    const bool command = std::holds_alternative<CommandTask>(task) || std::holds_alternative<SideTask>(task);
    m_commandsAsked += command ? 1 : 0;
    if (command && m_commands++ == 0)
        m_workingSince.start();
    m_waiting -= static_cast<int>(m_queue.push(std::move(task)));
}

void Editor::run(nlohmann::json command, std::function<void(bool)> then) {
    bool replaces = false;
    for (const auto& row : session::commandTable())
        replaces |= row.startsModel && command.value("op", "") == row.op;
    const std::string op = command.value("op", "");
    const auto kind = op == "undo" ? CommandKind::Undo : op == "redo" ? CommandKind::Redo : CommandKind::Other;
    CommandTask task{[command = std::move(command)](session::Context& context) { session::run(context, command); },
                     std::move(then), kind};
    if (replaces)
        replace(std::move(task));
    else
        push(std::move(task));
}

void Editor::recover(std::filesystem::path journal, std::function<void(bool, const session::Recovery&)> then) {
    const auto found = std::make_shared<session::Recovery>(); // set by the worker before `then` is called
    const auto work = [journal = std::move(journal), found](session::Context& context) {
        *found = session::recover(journal, context);
    };
    replace({work, [then = std::move(then), found](bool done) {
                 if (then)
                     then(done, *found);
             }});
}

void Editor::replay(std::filesystem::path session, std::function<void(bool)> then) {
    const auto work = [session = std::move(session)](session::Context& context) { session::replay(session, context); };
    replace({work, std::move(then)}); // most begin with a model
}

void Editor::saveSession(std::filesystem::path target, std::function<void(bool)> then) {
    const auto work = [target = std::move(target)](session::Context& context) {
        if (!context.journal)
            throw base::Error("cannot be written", target.string(), "no journal is kept in this window");
        context.journal->copyTo(target);
    };
    push(CommandTask{work, std::move(then)});
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

void Editor::saveCopy(std::filesystem::path path, std::function<void(bool)> then) {
    const auto work = [path = std::move(path)](session::Context& context) {
        session::Document copy = context.document;
        session::Context aside{copy, context.folder, context.progress, {}, 0, {}, context.journal};
        session::run(aside, {{"op", "save"}, {"path", path.string()}});
        context.messages = std::move(aside.messages);
    };
    push(CommandTask{work, std::move(then)});
}

void Editor::runAside(SideTask task) {
    push(std::move(task));
}

void Editor::copyDocument(std::shared_ptr<session::Document> into, std::function<void(bool)> then) {
    const auto copy = [this, into = std::move(into)](const surface::Surface&, const base::Progress&) {
        *into = m_worker->document();
    };
    push(SideTask{"", copy, std::move(then)});
}

void Editor::beginStroke(const sculpt::StrokeSettings& settings) {
    BeginStroke task{settings};
    m_strokeCancelled = task.cancelled;
    push(std::move(task));
}

void Editor::addSample(const sculpt::StrokeSample& sample, std::uint64_t input) {
    push(AddSamples{{sample}, input});
}

void Editor::endStroke() {
    push(EndStroke{});
}

void Editor::cancelStroke() {
    if (m_strokeCancelled)
        *m_strokeCancelled = true;
    push(CancelStroke{});
}

void Editor::cancelWork() {
    if (m_commands > 0)
        m_signals.cancel.cancel(m_commandsAsked - static_cast<std::uint64_t>(m_commands) + 1);
}

base::Hash128 Editor::hashWhenDone() {
    std::promise<base::Hash128> answer;
    push(
        SideTask{"Hashing",
                 [&](const surface::Surface&, const base::Progress&) { answer.set_value(m_worker->document().hash()); },
                 {}});
    return answer.get_future().get();
}

} // namespace ui
