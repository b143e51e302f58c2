#include "ui/window/command_desk.h"

#include "core/base/error.h"
#include "core/selection/affine.h"
#include "ui/window/command_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/parameter_values.h"

#include <algorithm>
#include <QScreen>

namespace ui {

CommandDesk::CommandDesk(MainWindow& window) : QObject(&window), m_window(window), m_preview(window.editor()) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseMs);
    connect(&m_pause, &QTimer::timeout, this, &CommandDesk::askPreview);
    connect(&m_preview, &CommandPreview::shown, this, &CommandDesk::show);
    connect(&m_preview, &CommandPreview::spread, this, [this](const Snapshot& floaters) {
        if (m_dialog && m_dialog->previews())
            m_window.sculptView().showInstead(floaters);
    });
    connect(&m_preview, &CommandPreview::failed, this, [this](const QString& why) {
        m_trying = false;
        m_window.sculptView().showInstead({});
        if (m_dialog)
            m_dialog->sayPreviewed(why);
    });
    connect(&m_preview, &CommandPreview::progressed, this, [this](double share, const QString& doing) {
        if (m_dialog && !doing.isEmpty())
            m_dialog->sayPreviewed(tr("Preview: %1, %2 %").arg(doing).arg(qRound(100 * share)));
    });
    connect(&window.editor(), &Editor::changed, this, &CommandDesk::followModel);
    connect(&window.sculptView().placement(), &PlacementTool::changed, this, &CommandDesk::enterPlacement);
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
    beginHandles();
    edited();
    if (const QString lacking = m_dialog->placeLacking(); !lacking.isEmpty() && !m_model.empty())
        pick(lacking);
}

void CommandDesk::connectDialog() {
    connect(m_dialog, &CommandDialog::changed, this, [this] {
        if (!m_entering)
            edited();
    });
    connect(m_dialog, &CommandDialog::placeWanted, this, &CommandDesk::pick);
    connect(m_dialog, &QDialog::finished, this, [this](int result) { finish(result == QDialog::Accepted); });
    connect(m_dialog, &CommandDialog::previewsSwitched, this, [this](bool on) {
        m_window.settings().previews = on;
        edited();
    });
    connect(m_dialog, &CommandDialog::errorSwitched, this, &CommandDesk::showFound);
}

/// In a corner of the picture; where that would hide it, over the panel beside it. Never off the screen.
void CommandDesk::place() {
    constexpr int margin = 12;
    const QWidget& canvas = *m_window.viewport().widget();
    const QRect screen = m_window.screen()->availableGeometry();
    const QSize size = m_dialog->frameGeometry().size();
    QPoint at = canvas.mapToGlobal(QPoint(margin, margin));
    if (2 * canvas.width() < 5 * size.width())
        at.setX(m_window.mapToGlobal(QPoint(m_window.width(), 0)).x() - size.width());
    at.setX(std::max(std::min(at.x(), screen.right() - size.width()), screen.left()));
    at.setY(std::max(std::min(at.y(), screen.bottom() - size.height()), screen.top()));
    m_dialog->move(at);
}

// --- what would come ---

/// While a handle is dragged each preview is made to its end, or none would ever come.
void CommandDesk::edited() {
    showPlacement();
    m_again = m_trying && m_dialog->previews() && m_window.sculptView().placement().dragging();
    if (m_again)
        return;
    m_preview.cancel();
    m_trying = false;
    m_found.reset();
    m_dialog->sayPreviewed({});
    if (m_dialog->previews())
        m_pause.start(m_window.sculptView().placement().dragging() ? 0 : pauseMs);
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
        m_trying = true;
    } catch (const base::Error& error) { // not yet a command
        m_window.sculptView().showInstead({});
        m_dialog->sayPreviewed(m_dialog->placeLacking().isEmpty() ? QString::fromStdString(error.message())
                                                                  : QString());
    }
}

void CommandDesk::show(const Previewed& found) {
    if (!m_dialog || !m_dialog->previews())
        return;
    m_found = found;
    showFound();
    m_dialog->sayPreviewed(found.said);
    m_trying = false;
    if (std::exchange(m_again, false))
        askPreview();
}

void CommandDesk::showFound() {
    if (!m_found)
        return;
    if (m_dialog && m_dialog->showsError())
        m_window.sculptView().showErrorOf(m_found->after);
    else
        m_window.sculptView().showInstead(m_found->after, m_found->gone);
}

// --- handles ---

/// For what a dialog calls moving, turning and scaling.
void CommandDesk::beginHandles() {
    PlacementTool& handles = m_window.sculptView().placement();
    for (const char* field : {"move", "axis", "angle", "scale"})
        if (!m_dialog->has(field))
            return handles.end();
    const selection::Limit limit = selection::boxUnder(m_model, selection::Limit::Selection).empty()
                                       ? selection::Limit::Everything
                                       : selection::Limit::Selection;
    const base::Box3f box = selection::boxUnder(m_model, limit);
    if (!box.empty())
        handles.begin(base::cast<double>(box.centre()));
    m_window.showHint(tr("Drag an arrow to move, a ring to turn, the square to scale; Ctrl goes by steps."));
}

void CommandDesk::enterPlacement() {
    if (!m_dialog)
        return;
    const Placement& now = m_window.sculptView().placement().placement();
    const AxisAngle turn = axisAngleOf(now.turn);
    const auto size = static_cast<double>(m_model.bounds().diagonal());
    m_entering = true;
    m_dialog->enter("move", length(now.move) > 0 ? textOf(now.move, size) : QString());
    m_dialog->enter("axis", turn.degrees > 0 ? textOf(turn.axis) : QString());
    m_dialog->enter("angle", turn.degrees > 0 ? QString::number(turn.degrees, 'g', 5) : QString());
    m_dialog->enter("scale", now.scale != 1 ? QString::number(now.scale, 'g', 4) : QString());
    m_entering = false;
    edited();
}

static base::Vec3d vectorOf(const nlohmann::json& command, const char* name) {
    const auto found = command.find(name);
    if (found == command.end() || !found->is_array() || found->size() != 3)
        return {};
    return {found->at(0), found->at(1), found->at(2)};
}

/// Handles stand where the numbers say, whoever has typed them.
void CommandDesk::showPlacement() {
    PlacementTool& handles = m_window.sculptView().placement();
    if (!handles.on() || handles.dragging())
        return;
    try {
        const nlohmann::json command = m_dialog->command();
        handles.set({vectorOf(command, "move"), rotationOf({vectorOf(command, "axis"), command.value("angle", 0.0)}),
                     command.value("scale", 1.0)});
    } catch (const std::exception&) { // not yet numbers
    }
}

void CommandDesk::followModel() {
    const Snapshot& now = m_window.editor().snapshot();
    if (!m_dialog || now.surface.tree() == m_model)
        return;
    m_model = now.surface.tree();
    if (m_window.sculptView().placement().on())
        beginHandles();
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
    const bool handles = m_window.sculptView().placement().on();
    m_window.sculptView().placement().end();
    if (handles)
        m_window.showHint(); // of the tool again
    m_trying = m_again = false;
    m_found.reset();
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
