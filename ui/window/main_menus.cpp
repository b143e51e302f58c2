// The menus of the main window: loops over tables wherever there is one.
#include "core/process/samples/samples.h"
#include "ui/panels/tool_bar.h"
#include "ui/window/command_dialog.h"
#include "ui/window/icon.h"
#include "ui/window/main_window.h"
#include "ui/window/shortcuts_dialog.h"
#include "ui/work/mesh_export.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QShortcut>
#include <QToolBar>

namespace ui {

QMenu* MainWindow::addMenu(const QString& name, const QString& title, QMenu* parent) {
    QMenu* out = parent ? parent->addMenu(title) : menuBar()->addMenu(title);
    out->setObjectName(name);
    out->setToolTipsVisible(true);
    return out;
}

QMenu* MainWindow::menu(const QString& name) const {
    return findChild<QMenu*>(name);
}

QAction* MainWindow::addAction(QMenu& menu, const char* iconName, const QString& text, const QKeySequence& shortcut,
                               const std::function<void()>& work) {
    QAction* out = menu.addAction(icon(iconName), text);
    out->setShortcut(shortcut);
    connect(out, &QAction::triggered, this, [work] { work(); });
    return out;
}

void MainWindow::buildFileMenu() {
    QMenu* file = addMenu("file", tr("&File"));
    QMenu* fresh = addMenu("new", tr("&New"), file);
    fresh->setIcon(icon("new"));
    for (const auto& row : process::sampleTable()) {
        QAction* action = addAction(*fresh, "model", row.label, {}, [this, id = row.id] { m_files->make(id); });
        action->setToolTip(row.tip);
        action->setData(row.id);
    }
    addAction(*file, "open", tr("&Open…"), QKeySequence::Open, [this] { m_files->open(); });
    addMenu("recent", tr("Open &Recent"), file);
    connect(m_files, &FileActions::recentChanged, this, &MainWindow::showRecent);
    showRecent();
    file->addSeparator();
    addAction(*file, "save", tr("&Save"), QKeySequence::Save, [this] { m_files->save(); });
    addAction(*file, "save-as", tr("Save &As…"), QKeySequence("Ctrl+Shift+S"), [this] { m_files->saveAs(); });
    addAction(*file, "image", tr("&Export Image…"), QKeySequence("Ctrl+E"), [this] { m_files->exportImage(); });
    QAction* mesh = addAction(*file, "", tr("Export &Mesh…"), QKeySequence("Ctrl+Shift+E"), [] {});
    mesh->setCheckable(true);
    mesh->setToolTip(tr("Triangles from the surface, seen over the picture before they are written"));
    connect(mesh, &QAction::toggled, m_mesh, &MeshExport::setOpen);
    file->addSeparator();
    addAction(*file, "recover", tr("Re&cover Lost Work…"), {}, [this] {
        if (!m_files->offerRecovery())
            Q_EMIT m_editor->told(tr("No other lost work was found."));
    });
    file->addSeparator();
    addAction(*file, "quit", tr("&Close"), QKeySequence("Ctrl+Q"), [this] { close(); });
}

void MainWindow::showRecent() {
    QMenu* recent = menu("recent");
    recent->clear();
    recent->setEnabled(!m_settings.recentFiles.empty());
    for (const std::string& path : m_settings.recentFiles) {
        const QFileInfo file(QString::fromStdString(path));
        QAction* action = recent->addAction(file.fileName());
        action->setToolTip(file.filePath());
        connect(action, &QAction::triggered, this, [this, path] { m_files->open(std::filesystem::path(path)); });
    }
}

void MainWindow::buildEditMenu() {
    QMenu* edit = addMenu("edit", tr("&Edit"));
    m_undo = addAction(*edit, "undo", tr("Undo"), QKeySequence("Ctrl+Z"), [this] { undo(); });
    m_redo = addAction(*edit, "redo", tr("Redo"), QKeySequence("Ctrl+Shift+Z"), [this] { redo(); });
    m_redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    auto* escapeKey = new QShortcut(QKeySequence(Qt::Key_Escape), this);
    connect(escapeKey, &QShortcut::activated, this, &MainWindow::escape);
}

void MainWindow::buildBrushMenu() {
    QMenu* brush = addMenu("brush", tr("&Brush"));
    brush->addActions(m_tools->toolActions());
    brush->addSeparator();
    constexpr double step = 1.15;
    addAction(*brush, "", tr("Larger"), QKeySequence("]"), [this] { m_controller->scaleRadius(step); });
    addAction(*brush, "", tr("Smaller"), QKeySequence("["), [this] { m_controller->scaleRadius(1 / step); });
    constexpr double part = 0.05;
    addAction(*brush, "", tr("Stronger"), QKeySequence("Shift+]"), [this] { m_controller->shiftStrength(part); });
    addAction(*brush, "", tr("Weaker"), QKeySequence("Shift+["), [this] { m_controller->shiftStrength(-part); });
}

void MainWindow::buildModelMenu() {
    QMenu* model = addMenu("model", tr("&Model"));
    for (const auto& row : session::commandTable()) {
        if (!hasDialog(row))
            continue;
        QAction* action = addAction(*model, row.op, tr("%1…").arg(row.label), {}, [this, &row] { ask(row); });
        action->setToolTip(row.tip);
        action->setData(row.op);
    }
}

/// What is wanted most often, for hands that hold a pen: in the corner of the menu bar.
void MainWindow::buildCorner() {
    auto* bar = new QToolBar;
    bar->setObjectName("corner");
    bar->setIconSize({18, 18});
    bar->setFixedHeight(24); // no taller than the menus beside it
    for (QAction* action : menu("file")->actions())
        if (action->shortcut() == QKeySequence::Open || action->shortcut() == QKeySequence::Save)
            bar->addAction(action);
    bar->addActions({m_undo, m_redo, m_frame});
    menuBar()->setCornerWidget(bar);
}

void MainWindow::ask(const session::CommandRow& row) {
    CommandDialog dialog(row, this);
    if (dialog.exec() == QDialog::Accepted)
        m_editor->run(dialog.command());
}

void MainWindow::buildViewMenu() {
    QMenu* view = addMenu("view", tr("&View"));
    buildLookMenus(*view);
    buildSwitches(*view);
    buildTrueSurface(*view);
    view->addSeparator();
    m_frame = addAction(*view, "frame", tr("Frame &All"), QKeySequence("Home"), [this] { m_controller->frameAll(); });
    buildNavigation(*view);
    buildClipping(*view);
    view->addSeparator();
    QAction* renderer = view->addAction(tr("Drawn by: %1").arg(m_viewport->rendererName()));
    renderer->setEnabled(false);
    renderer->setToolTip(m_whyRenderer);
    connect(view, &QMenu::aboutToShow, this,
            [this, renderer] { renderer->setText(tr("Drawn by: %1").arg(m_viewport->rendererName())); });
}

/// How the model looks: one menu for each table.
void MainWindow::buildLookMenus(QMenu& view) {
    const auto choice = [this](QMenu& in, QActionGroup& group, const auto& row, bool chosen, auto set) {
        QAction* action = addAction(in, "", row.label, {}, set);
        action->setToolTip(row.tip);
        action->setData(row.id);
        action->setCheckable(true);
        action->setChecked(chosen);
        group.addAction(action);
    };
    QMenu* shadings = addMenu("shading", tr("&Shading"), &view);
    auto* oneShading = new QActionGroup(this);
    const char* group = nullptr;
    for (const auto& row : render::shadingTable()) {
        if (!group || std::string_view(group) != row.group)
            shadings->addSection(tr(row.group));
        group = row.group;
        choice(*shadings, *oneShading, row, row.shading == m_settings.shading, [this, shading = row.shading] {
            m_settings.shading = shading;
            measure();
            m_controller->refresh();
        });
    }
    QMenu* backdrops = addMenu("background", tr("&Background"), &view);
    auto* oneBackdrop = new QActionGroup(this);
    for (const auto& row : render::backdropTable())
        choice(*backdrops, *oneBackdrop, row, row.backdrop == m_settings.backdrop, [this, backdrop = row.backdrop] {
            m_settings.backdrop = backdrop;
            m_controller->refresh();
        });
}

/// Switches of the picture: effects, and what stands around the model.
void MainWindow::buildSwitches(QMenu& view) {
    const auto toggle = [this](QMenu& in, const char* id, const char* label, const char* tip, bool on, auto set) {
        QAction* action = in.addAction(tr(label));
        action->setToolTip(tr(tip));
        action->setData(id);
        action->setCheckable(true);
        action->setChecked(on);
        connect(action, &QAction::toggled, this, [this, set](bool now) {
            set(now);
            m_controller->refresh();
        });
    };
    const auto bits = [this, toggle](QMenu& in, const auto& row, auto bit, std::uint32_t& set) {
        toggle(in, row.id, row.label, row.tip, set & bit,
               [&set, bit](bool now) { set = now ? set | bit : set & ~bit; });
    };
    QMenu* effects = addMenu("effects", tr("&Effects"), &view);
    for (const auto& row : render::effectTable())
        bits(*effects, row, std::uint32_t(row.effect), m_settings.effects);
    QMenu* around = addMenu("around", tr("&Around the Model"), &view);
    toggle(*around, "grid", "Grid on the Ground", "Lines at round coordinates below the model", m_settings.grid,
           [this](bool now) { m_settings.grid = now; });
    for (const auto& row : render::annotationTable())
        bits(*around, row, std::uint32_t(row.annotation), m_settings.annotated);
}

void MainWindow::buildHelpMenu() {
    QMenu* help = addMenu("help", tr("&Help"));
    addAction(*help, "keyboard", tr("&Shortcuts…"), QKeySequence("F1"), [this] {
        auto* dialog = new ShortcutsDialog(*this, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });
    addAction(*help, "about", tr("&About Pointclay…"), {}, [this] { about(); });
}

void MainWindow::about() {
    auto* box = new QMessageBox(this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(tr("About Pointclay"));
    box->setIconPixmap(icon("pointclay").pixmap(64, 64));
    box->setText(tr("<b>Pointclay %1</b><br>Sculpting and editing of point-set surfaces.")
                     .arg(QCoreApplication::applicationVersion()));
    box->setInformativeText(tr("Drawn by: %1 (%2).<br>Free software under the GNU General Public License, version 3 or "
                               "later.")
                                .arg(m_viewport->rendererName(), m_whyRenderer));
    box->open();
}

} // namespace ui
