#include "ui/window/main_window.h"

#include "core/render/shading/own_colours.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/tool_bar.h"
#include "ui/window/menus.h"
#include "ui/window/mesh_export.h"
#include "ui/window/status_line.h"
#include "ui/window/work_progress.h"
#include "ui/work/measurer.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QMimeData>
#include <QTimer>
#include <QUrl>

namespace ui {

/// A folder that refuses the journal is no reason not to start.
static Editor* startEditor(const EditorOptions& options, QObject* parent, QString& trouble) {
    try {
        return new Editor(options, parent);
    } catch (const base::Error& error) {
        trouble = QObject::tr("%1. Save often: a crash would lose what is not saved.").arg(error.what());
        return new Editor({.keepJournal = false, .journal = {}}, parent);
    }
}

MainWindow::MainWindow(const WindowOptions& options, QWidget* parent)
    : QMainWindow(parent), m_settingsFile(options.settingsFile), m_settings(m_settingsFile.read()) {
    QString trouble;
    m_editor = startEditor(options.editor, this, trouble);
    setAcceptDrops(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    buildViewport();
    m_files = new FileActions(*this, *m_editor, m_settings);
    m_images = new ImageExport(*this, *m_editor, m_settings, *m_view);
    buildStatus();
    buildTools();
    buildPanel();
    buildMenus();
    connectWork();
    showSnapshot();
    resize(1280, 800);
    restoreGeometry(m_settings.geometry);
    restoreState(m_settings.windowState);
    constexpr int pauseMs = 1000; // between a change and its being safe
    auto* clock = new QTimer(this);
    connect(clock, &QTimer::timeout, this, &MainWindow::keepSettings);
    clock->start(pauseMs);
    if (!trouble.isEmpty())
        tellFailure(trouble);
}

/// In this order, since what goes later is used by what goes earlier; the base class would take the children after the
/// members that they refer to.
MainWindow::~MainWindow() {
    m_editor->disconnect();
    delete m_view;
    delete m_mesh; // waits for its threads
    delete takeCentralWidget();
    delete m_panel;
    delete m_measurer; // waits for its thread
    delete m_editor;   // waits for its thread
}

// --- building ---

void MainWindow::buildViewport() {
    m_viewport = makeViewport(this, &m_whyRenderer);
    setCentralWidget(m_viewport->widget());
    m_viewport->widget()->setMinimumSize(320, 240);
    m_view = new SculptView(*m_editor, m_settings, *m_viewport, this);
    m_measurer = new Measurer(this);
    m_mesh = new MeshExport(*this, *m_editor, *m_viewport->widget());
    m_view->overlay().beneath = [this](QPainter& painter, const render::Camera& seen) { m_mesh->paint(painter, seen); };
    m_viewport->framePainted = [this](double seconds) { m_status->showFrame(seconds, m_viewport->rendererName()); };
    m_viewport->refined = [this](const auto& refinement) { m_status->showRefinement(refinement); };
    m_viewport->troubled = [this](const QString& trouble) { tellFailure(trouble); };
}

void MainWindow::buildStatus() {
    m_status = new StatusLine;
    setStatusBar(m_status);
    m_progress = new WorkProgress(*m_editor, *m_measurer, m_mesh->mesher(), *m_status, this);
    connect(m_view, &SculptView::hinted, this, &MainWindow::tell);
}

void MainWindow::buildTools() {
    m_tools = new ToolBar(m_settings);
    addToolBar(Qt::LeftToolBarArea, m_tools);
    connect(m_tools, &ToolBar::chosen, this, [this] {
        m_panel->refresh();
        tell(m_settings.toolRow().tip);
    });
}

void MainWindow::buildPanel() {
    m_panel = new PropertiesPanel(m_settings);
    auto* dock = new QDockWidget(tr("Properties"));
    dock->setObjectName("properties");
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    dock->setTitleBarWidget(new QWidget); // none: the headings inside say it
    dock->setWidget(m_panel);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    connect(m_panel, &PropertiesPanel::edited, m_view, [this] { m_view->refresh(); });
    connect(&m_view->sizing(), &BrushSizing::changed, m_panel, &PropertiesPanel::refresh);
    connect(&m_view->source(), &CloneSource::changed, m_panel, &PropertiesPanel::showSource);
}

void MainWindow::buildMenus() {
    addFileMenu(*this);
    addEditMenu(*this);
    addBrushMenu(*this);
    addModelMenu(*this);
    addViewMenu(*this);
    addHelpMenu(*this);
    addCornerBar(*this);
}

QMenu* MainWindow::menu(const QString& name) const {
    return findChild<QMenu*>(name);
}

void MainWindow::connectWork() {
    connect(m_editor, &Editor::changed, this, &MainWindow::showSnapshot);
    connect(m_editor, &Editor::told, this, &MainWindow::tell);
    connect(m_editor, &Editor::failed, this, &MainWindow::tellFailure);
    connect(m_measurer, &Measurer::changed, this,
            [this] { m_view->showColours(m_measurer->colours(), m_measurer->scale()); });
    connect(m_measurer, &Measurer::failed, this, &MainWindow::tellFailure);
    connect(&m_mesh->mesher(), &Mesher::failed, this, &MainWindow::tellFailure);
    connect(m_mesh, &MeshExport::told, this, &MainWindow::tell);
}

// --- showing ---

void MainWindow::showSnapshot() {
    const Snapshot& now = m_editor->snapshot();
    const QString name = now.path.empty() ? tr("Untitled") : QString::fromStdString(now.path.filename().string());
    setWindowTitle(tr("%1[*] – Pointclay").arg(name));
    setWindowModified(now.modified);
    m_status->showModel(now);
    measure();
    if (now.models != m_models) {
        m_models = now.models;
        suitShading();
        m_panel->setModelSize(static_cast<double>(now.surface.tree().bounds().diagonal()));
    }
}

/// A model with colours is shown in them, and the next one without is not left in plain light.
void MainWindow::suitShading() {
    const bool colours = render::hasOwnColours(m_editor->snapshot().surface.tree());
    if (colours == (m_settings.shading == render::Shading::Colour))
        return;
    const char* wanted = render::shadingRow(colours ? render::Shading::Colour : render::Shading::Matcap).id;
    for (QAction* action : menu("shading")->actions())
        if (action->data().toString() == wanted)
            action->trigger();
}

void MainWindow::measure() {
    const Snapshot& now = m_editor->snapshot();
    m_measurer->want(m_settings.shading, now.surface, now.reference, now.models);
    m_view->showColours(m_measurer->colours(), m_measurer->scale());
}

void MainWindow::tell(const QString& message) {
    m_status->tell(message);
}

void MainWindow::tellFailure(const QString& message) {
    m_status->tell(message, true);
}

void MainWindow::keepSettings() {
    m_settings.geometry = saveGeometry();
    m_settings.windowState = saveState();
    m_settingsFile.write(m_settings);
}

// --- undo and stopping ---

void MainWindow::undo() {
    if (!m_view->pointer().cancel())
        m_editor->run({{"op", "undo"}});
}

void MainWindow::redo() {
    m_editor->run({{"op", "redo"}});
}

void MainWindow::escape() {
    if (!m_view->pointer().cancel())
        m_progress->stop();
}

// --- leaving and dropping ---

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_mayClose && (m_editor->busy() || m_editor->snapshot().modified)) {
        event->ignore();
        m_files->unlessUnsaved([this] {
            m_mayClose = true;
            close();
        });
        return;
    }
    keepSettings();
    m_editor->discardJournal();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    m_files->open(std::filesystem::path(event->mimeData()->urls().front().toLocalFile().toStdString()));
}

} // namespace ui
