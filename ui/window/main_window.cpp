#include "ui/window/main_window.h"

#include "ui/panels/properties_panel.h"
#include "ui/panels/tool_bar.h"
#include "ui/window/status_line.h"
#include "ui/work/measurer.h"
#include "ui/work/mesh_export.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMimeData>
#include <QUrl>

namespace ui {

static std::unique_ptr<QSettings> openStore(const QString& file) {
    if (file.isEmpty())
        return std::make_unique<QSettings>("pointclay", "pointclay");
    return std::make_unique<QSettings>(file, QSettings::IniFormat);
}

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
    : QMainWindow(parent), m_store(openStore(options.settingsFile)), m_settings(readSettings(*m_store)) {
    QString trouble;
    m_editor = startEditor(options.editor, this, trouble);
    setAcceptDrops(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    buildViewport();
    m_files = new FileActions(*this, *m_editor, m_settings, *m_controller);
    buildBars();
    buildFileMenu();
    buildEditMenu();
    buildBrushMenu();
    buildModelMenu();
    buildViewMenu();
    buildHelpMenu();
    buildCorner();
    connectEditor();
    showSnapshot();
    resize(1280, 800);
    restoreGeometry(m_settings.geometry);
    restoreState(m_settings.windowState);
    if (!trouble.isEmpty())
        m_status->tell(trouble, true);
}

/// In this order, since what goes later is used by what goes earlier; the base class would take the children after the
/// members that they refer to.
MainWindow::~MainWindow() {
    m_editor->disconnect();
    delete m_controller;
    delete m_mesh; // waits for its threads
    delete takeCentralWidget();
    delete m_panel;
    delete m_measurer; // waits for its thread
    delete m_editor;   // waits for its thread
}

void MainWindow::buildViewport() {
    m_viewport = makeViewport(this, &m_whyRenderer);
    setCentralWidget(m_viewport->widget());
    m_viewport->widget()->setMinimumSize(320, 240);
    m_controller = new ViewController(*m_editor, m_settings, *m_viewport, this);
    m_measurer = new Measurer(this);
    m_mesh = new MeshExport(*this, *m_editor, *m_viewport->widget());
    m_controller->beneath = [this](QPainter& painter, const render::Camera& seen) { m_mesh->paint(painter, seen); };
    m_viewport->framePainted = [this](double seconds) { m_status->showFrame(seconds, m_viewport->rendererName()); };
    m_viewport->refined = [this](const auto& refinement) { m_status->showRefinement(refinement); };
    m_viewport->troubled = [this](const QString& trouble) { m_status->tell(trouble, true); };
}

void MainWindow::buildBars() {
    m_status = new StatusLine;
    setStatusBar(m_status);
    connect(m_status, &StatusLine::cancelled, m_editor, &Editor::cancelWork);
    connect(m_status, &StatusLine::cancelled, m_measurer, &Measurer::cancel);
    connect(m_status, &StatusLine::cancelled, &m_mesh->mesher(), &Mesher::cancel);

    m_tools = new ToolBar(m_settings);
    addToolBar(Qt::LeftToolBarArea, m_tools);
    connect(m_tools, &ToolBar::chosen, this, [this] {
        m_panel->refresh();
        m_status->tell(m_settings.toolRow().tip);
    });

    m_panel = new PropertiesPanel(m_settings);
    auto* dock = new QDockWidget(tr("Properties"));
    dock->setObjectName("properties");
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    dock->setTitleBarWidget(new QWidget); // none: the headings inside say it
    dock->setWidget(m_panel);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    connect(m_panel, &PropertiesPanel::edited, this, &MainWindow::settingsEdited);
    connect(m_controller, &ViewController::brushChanged, m_panel, &PropertiesPanel::refresh);
    connect(m_controller, &ViewController::sourceChanged, m_panel, &PropertiesPanel::showSource);
    connect(m_controller, &ViewController::hinted, this, [this](const QString& what) { m_status->tell(what); });
}

void MainWindow::connectEditor() {
    connect(m_editor, &Editor::changed, this, &MainWindow::showSnapshot);
    connect(m_editor, &Editor::progressed, this, &MainWindow::showProgress);
    connect(m_editor, &Editor::told, this, [this](const QString& message) { m_status->tell(message); });
    connect(m_editor, &Editor::failed, this, [this](const QString& message) { m_status->tell(message, true); });
    connect(m_measurer, &Measurer::changed, this,
            [this] { m_controller->showColours(m_measurer->colours(), m_measurer->scale()); });
    connect(m_measurer, &Measurer::failed, this, [this](const QString& why) { m_status->tell(why, true); });
    connect(m_measurer, &Measurer::progressed, this, &MainWindow::showProgress);
    const auto idled = [this] {
        if (working())
            return;
        m_working.invalidate();
        m_status->hideProgress();
    };
    connect(m_editor, &Editor::idled, this, idled);
    connect(m_measurer, &Measurer::idled, this, idled);
    connect(&m_mesh->mesher(), &Mesher::progressed, this, &MainWindow::showProgress);
    connect(&m_mesh->mesher(), &Mesher::idled, this, idled);
    connect(&m_mesh->mesher(), &Mesher::failed, this, [this](const QString& why) { m_status->tell(why, true); });
    connect(m_mesh, &MeshExport::told, this, [this](const QString& message) { m_status->tell(message); });
}

void MainWindow::showSnapshot() {
    const Snapshot& now = m_editor->snapshot();
    const QString name = now.path.empty() ? tr("Untitled") : QString::fromStdString(now.path.filename().string());
    setWindowTitle(tr("%1[*] – Pointclay").arg(name));
    setWindowModified(now.modified);
    m_undo->setEnabled(now.canUndo);
    m_undo->setText(now.canUndo ? tr("Undo %1").arg(QString::fromStdString(now.undoLabel)) : tr("Undo"));
    m_redo->setEnabled(now.canRedo);
    m_redo->setText(now.canRedo ? tr("Redo %1").arg(QString::fromStdString(now.redoLabel)) : tr("Redo"));
    m_status->showModel(now);
    measure();
    if (now.models != m_models) {
        m_models = now.models;
        m_panel->setModelSize(static_cast<double>(now.surface.tree().bounds().diagonal()));
    }
}

void MainWindow::showProgress(double share, const QString& doing) {
    constexpr qint64 patienceMs = 250; // shorter work shows no bar
    if (!m_working.isValid())
        m_working.start();
    if (working() && m_working.elapsed() >= patienceMs)
        m_status->showProgress(share, doing);
}

bool MainWindow::working() const {
    return m_editor->working() || m_measurer->busy() || m_mesh->mesher().busy();
}

void MainWindow::measure() {
    const Snapshot& now = m_editor->snapshot();
    m_measurer->want(m_settings.shading, now.surface, now.reference, now.models);
    m_controller->showColours(m_measurer->colours(), m_measurer->scale());
}

void MainWindow::settingsEdited() {
    m_controller->refresh();
}

void MainWindow::undo() {
    if (!m_controller->cancel()) // the stroke in progress goes first
        m_editor->run({{"op", "undo"}});
}

void MainWindow::redo() {
    m_editor->run({{"op", "redo"}});
}

void MainWindow::escape() {
    if (m_controller->cancel())
        return;
    if (m_editor->working())
        m_editor->cancelWork();
    m_measurer->cancel();
    m_mesh->mesher().cancel();
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
    m_settings.geometry = saveGeometry();
    m_settings.windowState = saveState();
    writeSettings(m_settings, *m_store);
    m_editor->discardJournalAtEnd();
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
