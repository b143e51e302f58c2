#include "ui/window/main_window.h"

#include "core/render/shading/own_colours.h"
#include "ui/panels/header_bar.h"
#include "ui/panels/properties_panel.h"
#include "ui/panels/tool_bar.h"
#include "ui/window/docks.h"
#include "ui/window/dropped.h"
#include "ui/window/file_dialogs.h"
#include "ui/window/keys.h"
#include "ui/window/menus/letters.h"
#include "ui/window/menus/menus.h"
#include "ui/window/mesh_export.h"
#include "ui/window/notices.h"
#include "ui/window/status_line.h"
#include "ui/window/thumbnails.h"
#include "ui/window/welcome.h"
#include "ui/window/work_progress.h"
#include "ui/words/words.h"
#include "ui/work/measurer.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QTimer>

namespace ui {

/// A folder that refuses the journal is no reason not to start.
static Editor* startEditor(const EditorOptions& options, QObject* parent, QString& trouble) {
    try {
        return new Editor(options, parent);
    } catch (const base::Error& error) {
        trouble = QObject::tr("%1. Save often: a crash would lose what is not saved.").arg(error.what());
        return new Editor({.keepJournal = false, .journal = {}, .historyBytes = options.historyBytes}, parent);
    }
}

MainWindow::MainWindow(const WindowOptions& options, QWidget* parent)
    : QMainWindow(parent), m_settingsFile(options.settingsFile), m_settings(m_settingsFile.read()) {
    QString trouble;
    EditorOptions editing = options.editor;
    editing.historyBytes = std::size_t(m_settings.historyMib) << 20;
    m_editor = startEditor(editing, this, trouble);
    setAcceptDrops(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    buildViewport();
    m_files = new FileActions(*this, *m_editor, m_settings);
    m_images = new ImageExport(*this, *m_editor, m_settings, *m_view);
    m_thumbnails = new Thumbnails(*this, options.pictures);
    buildStatus();
    buildTools();
    buildPanel();
    addDocks(*this);
    buildMenus();
    buildHeader();
    m_notices = new Notices(*m_view, *m_editor, *m_files, *m_progress, this);
    connect(m_notices, &Notices::comingChanged, this, &MainWindow::showTitle);
    connectWork();
    showSnapshot();
    if (m_settings.leftHanded)
        layOut(*this, true);
    resize(fitting(QSize(1280, 800)));
    // In this order: Qt keeps the bars' state of a window that it takes for maximised and too small for them, and falls
    // over it when they ask for another layout.
    restoreState(m_settings.windowState);
    restoreGeometry(m_settings.geometry);
    constexpr int pauseMs = 1000; // between a change and its being safe
    auto* clock = new QTimer(this);
    connect(clock, &QTimer::timeout, this, &MainWindow::keepSettings);
    clock->start(pauseMs);
    if (!trouble.isEmpty())
        tellFailure(trouble);
}

/// A window's size that a screen has room for, its frame included.
QSize MainWindow::fitting(const QSize& wanted) const {
    constexpr int frame = 40;
    return screen() ? wanted.boundedTo(screen()->availableSize() - QSize(frame, frame)) : wanted;
}

/// In this order, since what goes later is used by what goes earlier; the base class would take the children after the
/// members that they refer to.
MainWindow::~MainWindow() {
    m_editor->disconnect();
    delete m_notices;
    delete m_view;
    delete m_mesh; // waits for its threads
    delete m_bars;
    delete takeCentralWidget();
    delete m_panel;
    delete m_measurer; // waits for its thread
    delete m_editor;   // waits for its thread
}

// --- building ---

void MainWindow::buildViewport() {
    m_viewport = makeViewport(this, &m_whyRenderer);
    setCentralWidget(m_viewport->widget());
    m_viewport->widget()->setMinimumSize(160, 120);
    m_view = new SculptView(*m_editor, m_settings, *m_viewport, this);
    m_measurer = new Measurer(this);
    m_bars = new FloatingBars(*m_viewport->widget(), this);
    m_mesh = new MeshExport(*this, *m_editor, *m_viewport->widget(), *m_bars);
    m_view->overlay().beneath = [this](QPainter& painter, const render::Camera& seen) { m_mesh->paint(painter, seen); };
    m_viewport->framePainted = [this](double seconds) { m_status->showFrame(seconds, m_viewport->rendererName()); };
    m_viewport->refined = [this](const auto& refinement) {
        m_status->showRefinement(refinement);
        m_notices->refine(refinement);
    };
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
        m_view->picker().end(); // a tool is wanted in the hand
        m_panel->refresh();
        tell(spoken(m_settings.toolRow().tip));
        showHint();
    });
    showHint();
}

void MainWindow::showHint() {
    const sculpt::ToolRow& row = m_settings.toolRow();
    const QString hand =
        row.needs.source
            ? tr("Drag: %1; Ctrl+click: where to copy from").arg(spoken(row.label, "tool"))
            : tr("Drag: %1, with Ctrl the other way, with Shift %2")
                  .arg(spoken(row.label, "tool"), spoken(sculpt::tool(m_settings.shiftTool).label, "tool"));
    m_status->setHint(
        hand + tr("; beside the model or with the right button: turn the view; middle button: pan; wheel: zoom."));
}

void MainWindow::showHint(const QString& what) {
    m_status->setHint(what);
    tell(what);
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
    connect(m_panel, &PropertiesPanel::unitWanted, &m_view->sizing(), &BrushSizing::chooseUnit);
    connect(&m_view->pointer(), &PointerRouter::touched, this, &MainWindow::suitTool);
    connect(&m_view->source(), &CloneSource::changed, m_panel, &PropertiesPanel::showSource);
}

void MainWindow::buildMenus() {
    addFileMenu(*this);
    addEditMenu(*this);
    addBrushMenu(*this);
    addModelMenu(*this);
    addSelectMenu(*this);
    addMaskMenu(*this);
    addMeasureMenu(*this);
    addViewMenu(*this);
    addHelpMenu(*this);
    applyKeys(paletteEntries(*menuBar()), m_settings.keys);
    giveLetters(*menuBar());
    addCornerBar(*this);
}

void MainWindow::buildHeader() {
    m_header = new HeaderBar(m_settings);
    addToolBar(Qt::TopToolBarArea, m_header);
    m_header->addPopOver(*menu("shading"), tr("Shading"));
    m_header->addPopOver(*menu("effects"), tr("Effects"));
    m_header->addPopOver(*menu("around"), tr("Overlays"));
    connect(m_header, &HeaderBar::edited, this, [this] {
        m_panel->refresh();
        m_view->refresh();
    });
    connect(m_panel, &PropertiesPanel::edited, m_header, &HeaderBar::refresh);
    connect(m_tools, &ToolBar::chosen, m_header, &HeaderBar::refresh);
    connect(&m_view->sizing(), &BrushSizing::changed, m_header, &HeaderBar::refresh);
}

QMenu* MainWindow::menu(const QString& name) const {
    return findChild<QMenu*>(name);
}

void MainWindow::connectWork() {
    connect(m_editor, &Editor::changed, this, &MainWindow::showSnapshot);
    connect(m_view, &SculptView::shownChanged, this, &MainWindow::measure);
    connect(m_editor, &Editor::told, this, &MainWindow::tell);
    connect(m_editor, &Editor::failed, this, &MainWindow::tellFailure);
    connect(m_measurer, &Measurer::changed, this,
            [this] { m_view->showColours(m_measurer->colours(), m_measurer->scale()); });
    connect(m_measurer, &Measurer::failed, this, &MainWindow::tellFailure);
    connect(&m_mesh->mesher(), &Mesher::failed, this, &MainWindow::tellFailure);
    connect(m_mesh, &MeshExport::told, this, &MainWindow::tell);
}

// --- showing ---

void MainWindow::showTitle() {
    const Snapshot& now = m_editor->snapshot();
    if (const QString& coming = m_notices->coming(); !coming.isEmpty()) { // never "Untitled" while a file is on its way
        setWindowModified(false);
        return setWindowTitle(tr("%1…[*] – Pointclay").arg(coming));
    }
    const QString name = now.path.empty() ? tr("Untitled") : QString::fromStdString(now.path.filename().string());
    setWindowTitle(tr("%1[*] – Pointclay").arg(name));
    setWindowModified(now.modified);
}

void MainWindow::showSnapshot() {
    const Snapshot& now = m_editor->snapshot();
    showTitle();
    m_status->showModel(now);
    measure();
    if (now.models != m_models) {
        m_models = now.models;
        suitShading();
    }
    if (std::exchange(m_model, now.model) != now.model) {
        m_panel->setModelSize(static_cast<double>(now.surface.tree().bounds().diagonal()));
        m_header->setModelSize(static_cast<double>(now.surface.tree().bounds().diagonal()));
    }
}

static void chooseShading(QMenu& menu, render::Shading shading) {
    const char* wanted = render::shadingRow(shading).id;
    for (QAction* action : menu.actions())
        if (action->data().toString() == wanted)
            action->trigger();
}

void MainWindow::showShading(render::Shading shading) {
    chooseShading(*menu("shading"), shading);
}

/// A model with colours is shown in them, and the next one without is not left in plain light.
void MainWindow::suitShading() {
    const tree::SurfelTree& model = m_editor->snapshot().surface.tree();
    const bool colours = render::hasOwnColours(model);
    const bool lost = m_settings.shading == render::Shading::Attribute && !model.layout()->find(m_settings.attribute);
    const render::Shading usual = render::usualShading(model);
    const bool taken = usual == render::Shading::Unlit && m_settings.shading == render::Shading::Colour;
    if (lost || taken || colours != render::shadingRow(m_settings.shading).surfelColours)
        chooseShading(*menu("shading"), usual);
}

/// What a stroke writes is to be seen: colours are not under a material, nor masks among measured numbers.
void MainWindow::suitTool(const QString& tool) {
    const render::ShadingRow& shown = render::shadingRow(m_settings.shading);
    const sculpt::Writes writes = sculpt::tool(tool.toStdString()).writes;
    if (writes == sculpt::Writes::Colour && !shown.surfelColours) {
        chooseShading(*menu("shading"), render::Shading::Colour);
        tell(tr("Shown in its colours from now on. View > Shading has the others."));
    } else if (writes == sculpt::Writes::Count && m_settings.shading != render::Shading::Spacing)
        tell(tr("Points come and go without a trace in this shading; View > Shading > %1 shows how dense they are.")
                 .arg(tr(render::shadingRow(render::Shading::Spacing).label)));
    else if (writes == sculpt::Writes::Mask && shown.measure) {
        chooseShading(*menu("shading"), render::Shading::Mask);
        tell(tr("Shown with its mask from now on. View > Shading has the others."));
    }
}

void MainWindow::measure() {
    const Snapshot& now = m_view->look().shown();
    m_measurer->want(m_view->look().shading(), m_settings.attribute, now.surface, now.reference, now.models);
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

void MainWindow::go(int steps) {
    m_view->pointer().cancel();
    for (int left = std::abs(steps); left > 0; --left)
        m_editor->run({{"op", steps < 0 ? "undo" : "redo"}});
}

void MainWindow::escape() {
    const bool felt = m_view->touch().stop(); // whatever else: no force
    if (m_view->placement().cancel() || m_view->picker().cancel() || m_view->pointer().cancel() || felt)
        return;
    if (m_view->picker().on())
        m_view->picker().end();
    else if (!closeCards(*this))
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

/// Says before the button comes up what will happen.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto files = localFiles(*event->mimeData());
    if (files.empty())
        return;
    const QString name = textOf(files.front().filename());
    switch (droppedAs(files.front())) {
    case Dropped::Model:
        m_view->setNotice(
            {files.size() > 1 ? tr("Drop to open %1 models").arg(files.size()) : tr("Drop to open %1").arg(name), -1});
        break;
    case Dropped::Image:
        m_view->setNotice({tr("Drop to press %1 in with the brush").arg(name), -1});
        break;
    case Dropped::Folder:
        m_view->setNotice({tr("Drop to choose a model in %1").arg(name), -1});
        break;
    case Dropped::Other:
        m_view->setNotice({tr("%1 is neither a model nor an image").arg(name), -1});
    }
    event->acceptProposedAction();
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
    m_view->setNotice({});
}

/// The first model is opened here, each further one in a window of its own.
void MainWindow::dropEvent(QDropEvent* event) {
    m_view->setNotice({});
    bool here = true;
    for (const std::filesystem::path& file : localFiles(*event->mimeData()))
        switch (droppedAs(file)) {
        case Dropped::Model:
            if (here || !openAnother)
                m_files->open(file);
            else
                openAnother(file);
            here = false;
            break;
        case Dropped::Image:
            m_settings.edit(m_settings.toolRow()).stamp = file.string();
            m_panel->refresh();
            tell(tr("The brush presses %1 in from now on.").arg(textOf(file.filename())));
            break;
        case Dropped::Folder:
            m_files->openIn(file);
            break;
        case Dropped::Other:
            tellFailure(tr("%1 is neither a model nor an image; File > Open says what can be read.")
                            .arg(textOf(file.filename())));
        }
    event->acceptProposedAction();
}

} // namespace ui
