#include "ui/window/file_actions.h"

#include "core/base/error.h"
#include "core/io/text/text_preview.h"
#include "core/session/journal.h"
#include "core/session/model_argument.h"
#include "core/session/scene/scene_file.h"
#include "ui/theme/icon.h"
#include "ui/window/command_dialog.h"
#include "ui/window/file_dialogs.h"
#include "ui/window/recovery_dialog.h"

#include <QAbstractButton>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QRegularExpression>

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

// --- sessions ---

void FileActions::runSession() {
    const QString file = QFileDialog::getOpenFileName(&m_window, tr("Run Session"), folder(), sessionFilter());
    if (!file.isEmpty())
        runSession(pathOf(file));
}

void FileActions::runSession(const fs::path& session) {
    unlessUnsaved([this, session] {
        m_failure.clear();
        Q_EMIT began(tr("Running %1").arg(textOf(session.filename())));
        m_editor.replay(session, [this, session](bool done) {
            Q_EMIT ended();
            if (!done)
                m_failure.show(tr("%1 did not come to its end").arg(textOf(session.filename())));
        });
    });
}

void FileActions::saveSession() {
    QString file = QFileDialog::getSaveFileName(&m_window, tr("Save Session"), folder(), sessionFilter());
    if (file.isEmpty())
        return;
    if (QFileInfo(file).suffix().isEmpty()) {
        file += ".jsonl";
        const QString question = tr("%1 is there already. Replace it?").arg(QFileInfo(file).fileName());
        if (QFileInfo::exists(file) && // the dialog has asked about the shorter name only
            QMessageBox::question(&m_window, tr("Save Session"), question) != QMessageBox::Yes)
            return;
    }
    m_failure.clear();
    m_editor.saveSession(pathOf(file), [this](bool done) {
        if (!done)
            m_failure.show(tr("Could not save the session"));
    });
}

// --- new and open ---

void FileActions::make(const std::string& sample) {
    unlessUnsaved([this, sample] { m_editor.run({{"op", "new"}, {"sample", sample}}); });
}

void FileActions::open() {
    openIn(pathOf(folder()));
}

void FileActions::openIn(const fs::path& folder) {
    const QString file = QFileDialog::getOpenFileName(&m_window, tr("Open Model"), textOf(folder), openFilter());
    if (!file.isEmpty())
        open(pathOf(file));
}

/// Points as text under names that mean nothing to us. What else is wrong with a file, opening says.
static bool isDoubtful(const fs::path& path) {
    try {
        const auto preview = io::previewText(path);
        return preview && !preview->sure;
    } catch (const base::Error&) {
        return false;
    }
}

void FileActions::open(const fs::path& path) {
    if (isDoubtful(path))
        openWith(path);
    else
        unlessUnsaved([this, path] { load(path); });
}

void FileActions::openArgument(const std::string& model) {
    if (!model.starts_with("sample:"))
        return open(model);
    m_failure.clear();
    const QString title = tr("Could not make %1").arg(QString::fromStdString(model));
    try {
        const nlohmann::json command = session::modelCommand(model);
        Q_EMIT began(tr("Making %1").arg(QString::fromStdString(model)));
        m_editor.run(command, [this, title](bool done) {
            Q_EMIT ended();
            if (!done)
                m_failure.show(title);
        });
    } catch (const base::Error& error) {
        m_failure.show(title, QString::fromStdString(error.message()));
    }
}

void FileActions::openWith(const fs::path& path) {
    auto* dialog = new CommandDialog(session::command("open"), m_editor.snapshot(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (!path.empty())
        dialog->enter("path", textOf(fs::absolute(path)));
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const nlohmann::json command = dialog->command();
        unlessUnsaved([this, command] { load(command.at("path").get<std::string>(), command); });
    });
    dialog->open();
}

void FileActions::load(const fs::path& path, nlohmann::json command) {
    m_failure.clear();
    const fs::path whole = fs::absolute(path);
    Q_EMIT began(tr("Opening %1").arg(textOf(whole.filename())));
    command["op"] = "open";
    command["path"] = whole.string();
    m_editor.run(std::move(command), [this, whole](bool done) {
        Q_EMIT ended();
        if (done)
            remember(whole);
        else
            m_failure.show(tr("Could not open %1").arg(textOf(whole.filename())));
    });
}

void FileActions::add() {
    const QString file = QFileDialog::getOpenFileName(&m_window, tr("Add Model"), folder(), openFilter());
    if (file.isEmpty())
        return;
    const fs::path whole = fs::absolute(pathOf(file));
    if (m_editor.snapshot().surfels == 0)
        return load(whole);
    m_failure.clear();
    m_editor.run({{"op", "scene"}, {"do", "add"}, {"path", whole.string()}}, [this, whole](bool done) {
        if (!done)
            m_failure.show(tr("Could not add %1").arg(textOf(whole.filename())));
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

fs::path FileActions::askTarget(const QString& title) {
    const fs::path& path = m_editor.snapshot().path;
    const fs::path suggested = path.empty()     ? fs::path("untitled.ply")
                               : isNative(path) ? path.filename()
                                                : path.filename().replace_extension(".ply");
    QString filter;
    const QString start = folder().isEmpty() ? textOf(suggested) : folder() + "/" + textOf(suggested);
    const QString file = QFileDialog::getSaveFileName(&m_window, title, start, saveFilter(), &filter);
    return file.isEmpty() ? fs::path() : completed(file, filter);
}

void FileActions::saveAs(std::function<void()> then) {
    if (const fs::path path = askTarget(tr("Save Model")); !path.empty())
        write(path, std::move(then));
}

void FileActions::saveCopy() {
    if (const fs::path path = askTarget(tr("Save a Copy")); !path.empty())
        saveCopy(path);
}

void FileActions::saveCopy(const fs::path& path) {
    m_failure.clear();
    const fs::path whole = fs::absolute(path);
    m_editor.saveCopy(whole, [this, whole](bool done) {
        if (!done)
            return m_failure.show(tr("Could not save %1").arg(textOf(whole.filename())));
        Q_EMIT m_editor.told(tr("Saved a copy, %1").arg(textOf(whole)));
    });
}

fs::path nextVersion(const fs::path& path) {
    static const QRegularExpression numbered("^(.*)_(\\d{3,6})$");
    const QRegularExpressionMatch match = numbered.match(textOf(path.stem()));
    const QString stem = match.hasMatch() ? match.captured(1) : textOf(path.stem());
    int number = match.hasMatch() ? match.captured(2).toInt() : 1;
    fs::path out;
    std::error_code none;
    do {
        out = path.parent_path() / (stem + QString("_%1").arg(++number, 3, 10, QChar('0'))).toStdString();
        out += path.extension();
    } while (fs::exists(out, none));
    return out;
}

void FileActions::saveVersion() {
    const fs::path& path = m_editor.snapshot().path;
    if (path.empty() || !isNative(path) || session::isSceneFile(path))
        saveAs();
    else
        write(nextVersion(path), {});
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
    box->button(QMessageBox::Discard)->setText(tr("&Discard"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    connect(box, &QMessageBox::finished, this, [this, next = std::move(next)](int answer) {
        if (answer == QMessageBox::Discard)
            next();
        else if (answer == QMessageBox::Save)
            save(next);
    });
    box->open();
}

bool FileActions::offerRecovery() {
    for (const session::LeftJournal& journal : session::findLeftJournals()) {
        if (journal.commands == 0) { // nothing is lost
            session::removeJournal(journal.path);
            continue;
        }
        RecoveryDialog dialog(journal, &m_window);
        const int answer = dialog.exec();
        if (answer == RecoveryDialog::Recover) {
            unlessUnsaved([this, journal] { recover(journal); });
            return true;
        }
        if (answer == RecoveryDialog::Discard)
            session::removeJournal(journal.path);
    }
    return false;
}

void FileActions::recover(const session::LeftJournal& journal) {
    m_failure.clear();
    const QString name = journal.model.empty() ? tr("a new model") : textOf(journal.model.filename());
    Q_EMIT began(tr("Recovering %1").arg(name));
    m_editor.recover(journal.path, [this, path = journal.path, name](bool done, const session::Recovery& found) {
        Q_EMIT ended();
        if (!done)
            return m_failure.show(tr("Could not recover the lost work"));
        if (found.leftOut > 0) // what is lost may be mended by hand
            return m_editor.told(
                tr("Recovered %1 but for %n step(s), which %2 still holds. Save it to keep it.", "", found.leftOut)
                    .arg(name, textOf(path)));
        session::removeJournal(path); // this window's own journal holds it all now
        const QString steps = stepsText(found);
        Q_EMIT m_editor.told(steps.isEmpty() ? tr("Recovered %1. Save it to keep it.").arg(name)
                                             : tr("Recovered %1: %2. Save it to keep it.").arg(name, steps));
    });
}

} // namespace ui
