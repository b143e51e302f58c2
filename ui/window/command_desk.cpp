#include "ui/window/command_desk.h"

#include "core/base/error.h"
#include "ui/window/command_dialog.h"
#include "ui/window/main_window.h"

namespace ui {

CommandDesk::CommandDesk(MainWindow& window) : QObject(&window), m_window(window), m_preview(window.editor()) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseMs);
    connect(&m_pause, &QTimer::timeout, this, &CommandDesk::askPreview);
    connect(&m_preview, &CommandPreview::shown, this, &CommandDesk::show);
    connect(&m_preview, &CommandPreview::failed, this, [this](const QString& why) {
        m_window.sculptView().showInstead({});
        if (m_dialog)
            m_dialog->sayPreviewed(why);
    });
    connect(&m_preview, &CommandPreview::progressed, this, [this](double share, const QString& doing) {
        if (m_dialog && !doing.isEmpty())
            m_dialog->sayPreviewed(tr("Preview: %1, %2 %").arg(doing).arg(qRound(100 * share)));
    });
    connect(&window.editor(), &Editor::changed, this, &CommandDesk::followModel);
}

/// The plane that cuts the picture open, in the file's coordinates.
static std::optional<base::Plane> cutShown(MainWindow& window) {
    for (const Cut& cut : window.sculptView().cuts().cuts().each)
        if (cut.on)
            return cut.plane().relativeTo(-window.editor().snapshot().origin);
    return {};
}

void CommandDesk::open(const session::CommandRow& row) {
    if (m_dialog)
        m_dialog->close();
    const Snapshot& now = m_window.editor().snapshot();
    m_model = now.surface.tree();
    m_dialog = new CommandDialog(row, now, &m_window, cutShown(m_window));
    m_dialog->setAttribute(Qt::WA_DeleteOnClose);
    m_dialog->setPreviews(m_window.settings().previews);
    connectDialog();
    m_dialog->show();
    place();
    edited();
    if (const QString lacking = m_dialog->placeLacking(); !lacking.isEmpty() && !m_model.empty())
        pick(lacking);
}

void CommandDesk::connectDialog() {
    connect(m_dialog, &CommandDialog::changed, this, &CommandDesk::edited);
    connect(m_dialog, &CommandDialog::placeWanted, this, &CommandDesk::pick);
    connect(m_dialog, &QDialog::finished, this, [this](int result) { finish(result == QDialog::Accepted); });
    connect(m_dialog, &CommandDialog::previewsSwitched, this, [this](bool on) {
        m_window.settings().previews = on;
        edited();
    });
}

/// Beside the model, as far as there is room.
void CommandDesk::place() {
    constexpr int margin = 12;
    const QWidget& canvas = *m_window.viewport().widget();
    m_dialog->move(canvas.mapToGlobal(QPoint(margin, margin)));
}

// --- what would come ---

void CommandDesk::edited() {
    m_preview.cancel();
    m_dialog->sayPreviewed({});
    if (m_dialog->previews())
        m_pause.start();
    else {
        m_pause.stop();
        m_window.sculptView().showInstead({});
    }
}

void CommandDesk::askPreview() {
    if (!m_dialog || m_model.empty())
        return;
    try {
        m_preview.want(m_dialog->command());
    } catch (const base::Error& error) { // not yet a command
        m_window.sculptView().showInstead({});
        m_dialog->sayPreviewed(m_dialog->placeLacking().isEmpty() ? QString::fromStdString(error.message())
                                                                  : QString());
    }
}

void CommandDesk::show(const Previewed& found) {
    if (!m_dialog || !m_dialog->previews())
        return;
    m_window.sculptView().showInstead(found.after, found.gone);
    m_dialog->sayPreviewed(found.said);
}

void CommandDesk::followModel() {
    const Snapshot& now = m_window.editor().snapshot();
    if (!m_dialog || now.surface.tree() == m_model)
        return;
    m_model = now.surface.tree();
    m_dialog->setModel(now);
}

// --- places ---

void CommandDesk::pick(const QString& field) {
    if (field.isEmpty())
        return m_window.sculptView().picker().end();
    const bool several = m_dialog->takesSeveral(field);
    const auto taken = [this, field, several](const Pick& found) {
        if (!m_dialog)
            return;
        m_dialog->takePlace(field, found.contact->position + m_window.editor().snapshot().origin,
                            found.contact->normal);
        if (const QString next = m_dialog->placeLacking(); !several && !next.isEmpty())
            pick(next);
        else if (!several)
            m_window.sculptView().picker().end();
    };
    m_window.sculptView().picker().begin({PickShape::Place, taken, [this] { endPick(); }});
    m_picking = true;
    m_dialog->setPicking(field);
    m_window.showHint(several ? tr("Click places on the model, one after the other; Esc ends it.")
                              : tr("Click a place on the model; Esc goes back to sculpting."));
}

void CommandDesk::endPick() {
    m_picking = false;
    if (m_dialog)
        m_dialog->setPicking({});
    m_window.showHint();
}

// --- its end ---

void CommandDesk::finish(bool accepted) {
    if (m_picking)
        m_window.sculptView().picker().end();
    m_pause.stop();
    m_preview.cancel();
    CommandDialog* const dialog = m_dialog;
    m_dialog.clear();
    if (!accepted || !dialog)
        return m_window.sculptView().showInstead({});
    // What was shown stays until it is there.
    m_window.editor().run(dialog->command(), [desk = QPointer(this)](bool) {
        if (desk && !desk->m_dialog)
            desk->m_window.sculptView().showInstead({});
    });
}

} // namespace ui
