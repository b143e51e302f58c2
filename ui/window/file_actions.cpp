#include "ui/window/file_actions.h"

#include "core/session/journal.h"
#include "core/session/model_argument.h"
#include "core/session/recover.h"
#include "ui/theme/icon.h"
#include "ui/window/file_dialogs.h"

#include <chrono>
#include <QDateTime>
#include <QFileDialog>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>

namespace ui {

namespace fs = std::filesystem;

FileActions::FileActions(QMainWindow& window, Editor& editor, Settings& settings)
    : QObject(&window), m_window(window), m_editor(editor), m_settings(settings), m_failure(window, editor) {}

QString FileActions::folder() const {
    return folderFor(m_editor.snapshot(), m_settings);
}

void FileActions::remember(const fs::path& path) {
    m_settings.remember(path.string());
    Q_EMIT recentChanged();
}

// --- new and open ---

void FileActions::make(const std::string& sample) {
    unlessUnsaved([this, sample] { m_editor.run({{"op", "new"}, {"sample", sample}}); });
}

void FileActions::open() {
    const QString file = QFileDialog::getOpenFileName(&m_window, tr("Open Model"), folder(), openFilter());
    if (!file.isEmpty())
        open(pathOf(file));
}

void FileActions::open(const fs::path& path) {
    unlessUnsaved([this, path] { load(path); });
}

void FileActions::openArgument(const std::string& model) {
    if (!model.starts_with("sample:"))
        return open(model);
    m_failure.clear();
    const QString title = tr("Could not make %1").arg(QString::fromStdString(model));
    try {
        m_editor.run(session::modelCommand(model), [this, title](bool done) {
            if (!done)
                m_failure.show(title);
        });
    } catch (const base::Error& error) {
        m_failure.show(title, QString::fromStdString(error.message()));
    }
}

void FileActions::load(const fs::path& path) {
    m_failure.clear();
    const fs::path whole = fs::absolute(path);
    m_editor.run({{"op", "open"}, {"path", whole.string()}}, [this, whole](bool done) {
        if (done)
            remember(whole);
        else
            m_failure.show(tr("Could not open %1").arg(textOf(whole.filename())));
    });
}

// --- save ---

void FileActions::save(std::function<void()> then) {
    const fs::path& path = m_editor.snapshot().path;
    if (path.empty() || !isNative(path))
        saveAs(std::move(then));
    else
        write(path, std::move(then));
}

void FileActions::saveAs(std::function<void()> then) {
    const fs::path& path = m_editor.snapshot().path;
    const fs::path suggested = path.empty() ? fs::path("untitled.ply") : path.filename().replace_extension(".ply");
    QString filter;
    const QString start = folder().isEmpty() ? textOf(suggested) : folder() + "/" + textOf(suggested);
    const QString file = QFileDialog::getSaveFileName(&m_window, tr("Save Model"), start, saveFilter(), &filter);
    if (!file.isEmpty())
        write(completed(file, filter), std::move(then));
}

void FileActions::write(const fs::path& path, std::function<void()> then) {
    m_failure.clear();
    const fs::path whole = fs::absolute(path);
    m_editor.run({{"op", "save"}, {"path", whole.string()}}, [this, whole, then = std::move(then)](bool done) {
        if (!done)
            return m_failure.show(tr("Could not save %1").arg(textOf(whole.filename())));
        remember(whole);
        Q_EMIT m_editor.told(isNative(whole) ? tr("Saved %1").arg(textOf(whole))
                                             : tr("Wrote %1; only a .ply keeps everything").arg(textOf(whole)));
        if (then)
            then();
    });
}

// --- unsaved and lost work ---

void FileActions::unlessUnsaved(std::function<void()> next) {
    if (m_editor.busy()) { // what is under way decides whether there is something to lose
        if (m_editor.working())
            Q_EMIT m_editor.told(tr("Waiting for the work in progress; Esc stops it."));
        const auto again = [this, next = std::move(next)] { unlessUnsaved(next); };
        connect(&m_editor, &Editor::idled, this, again, Qt::SingleShotConnection);
        return;
    }
    if (!m_editor.snapshot().modified)
        return next();
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Unsaved changes"),
                                tr("The model has changes that are not saved. Save them first?"),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box->setIconPixmap(icon("save").pixmap(32, 32));
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [this, next = std::move(next)](int answer) {
        if (answer == QMessageBox::Discard)
            next();
        else if (answer == QMessageBox::Save)
            save(next);
    });
    box->open();
}

static QString describe(const session::LeftJournal& journal) {
    const auto when = std::chrono::file_clock::to_sys(journal.time);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(when.time_since_epoch()).count();
    const QString name = journal.model.empty() ? QObject::tr("a new model") : textOf(journal.model.filename());
    const QString steps = journal.commands == 1 ? QObject::tr("1 step") : QObject::tr("%1 steps").arg(journal.commands);
    return QObject::tr("%1 (%2, last changed %3)")
        .arg(name, steps, QDateTime::fromSecsSinceEpoch(seconds).toString("yyyy-MM-dd hh:mm"));
}

bool FileActions::offerRecovery() {
    for (const session::LeftJournal& journal : session::findLeftJournals()) {
        if (journal.commands == 0) { // nothing is lost
            session::removeJournal(journal.path);
            continue;
        }
        QMessageBox box(QMessageBox::NoIcon, tr("Recover lost work?"),
                        tr("The program ended without saving %1.").arg(describe(journal)), QMessageBox::NoButton,
                        &m_window);
        box.setIconPixmap(icon("recover").pixmap(32, 32));
        const auto* recovered = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
        const auto* discarded = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
        box.addButton(tr("Later"), QMessageBox::RejectRole);
        box.exec();
        if (box.clickedButton() == recovered) {
            unlessUnsaved([this, path = journal.path] { recover(path); });
            return true;
        }
        if (box.clickedButton() == discarded)
            session::removeJournal(journal.path);
    }
    return false;
}

void FileActions::recover(const fs::path& journal) {
    m_failure.clear();
    m_editor.recover(journal, [this, journal](bool done, int leftOut) {
        if (!done)
            return m_failure.show(tr("Could not recover the lost work"));
        if (leftOut > 0) // what is lost may be mended by hand
            return m_editor.told(
                tr("Recovered but for %n step(s), which %1 still holds. Save it to keep it.", "", leftOut)
                    .arg(textOf(journal)));
        session::removeJournal(journal); // this window's own journal holds it all now
        Q_EMIT m_editor.told(tr("Recovered. Save it to keep it."));
    });
}

} // namespace ui
