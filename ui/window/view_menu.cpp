// The part of the View menu that moves and cuts the view: named and saved views, projection, styles, flight, clipping.
#include "ui/panels/cut_bar.h"
#include "ui/panels/truth_bar.h"
#include "ui/window/icon.h"
#include "ui/window/main_window.h"

#include <QActionGroup>
#include <QInputDialog>
#include <QMenu>

namespace ui {

void MainWindow::buildNavigation(QMenu& view) {
    addAction(view, "frame", tr("Frame &Selection"), QKeySequence("."), [this] {
        m_controller->frameSelection();
    })->setToolTip(tr("What is not masked; without a mask, what is under the brush"));
    for (const auto& row : render::namedViews())
        addAction(view, "view", tr(row.label), QKeySequence(row.shortcut), [this, &row] { m_controller->turnTo(row); });
    QAction* parallel =
        addAction(view, "view", tr("&Orthographic"), QKeySequence("5"), [this] { m_controller->toggleParallel(); });
    parallel->setCheckable(true);
    parallel->setToolTip(tr("Parallel rays: no perspective"));
    connect(m_controller, &ViewController::viewChanged, parallel,
            [this, parallel] { parallel->setChecked(m_controller->view().parallel); });

    QMenu* saved = addMenu("saved-views", tr("Sa&ved Views"), &view);
    connect(saved, &QMenu::aboutToShow, this, &MainWindow::showSavedViews);
    showSavedViews();

    QMenu* styles = addMenu("navigation", tr("&Navigation"), &view);
    auto* group = new QActionGroup(this);
    for (const NavigationRow& row : navigationTable()) {
        QAction* action = addAction(*styles, "", tr(row.label), {}, [this, &row] {
            m_settings.navigation = row.id;
            m_controller->navigator().chooseStyle(row);
        });
        action->setToolTip(tr(row.tip));
        action->setCheckable(true);
        action->setChecked(&row == &navigation(m_settings.navigation));
        group->addAction(action);
    }
    styles->addSeparator();
    addAction(*styles, "", tr("&Pivot Under the Pointer"), QKeySequence("O"), [this] {
        m_controller->pickPivot();
    })->setToolTip(tr("Turn about the place of the surface there; beside the model, about the middle of the view"));
    QAction* fly = addAction(*styles, "", tr("&Fly"), QKeySequence("F4"), [this] { m_controller->fly(); });
    fly->setShortcuts({QKeySequence("F4"), QKeySequence("Shift+`"), QKeySequence("Shift+~")});
    fly->setToolTip(tr("Move with W A S D, Q and E, look with the pointer; Esc lands"));
}

/// The names, a way to delete each, and a way to add one.
void MainWindow::showSavedViews() {
    QMenu* saved = menu("saved-views");
    qDeleteAll(saved->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
    saved->clear();
    addAction(*saved, "", tr("&Save View…"), QKeySequence("Ctrl+Shift+V"), [this] { saveView(); });
    saved->addSeparator();
    for (const SavedView& view : m_settings.savedViews)
        addAction(*saved, "view", QString::fromStdString(view.name), {}, [this, name = view.name] {
            if (const SavedView* found = findView(m_settings.savedViews, name))
                m_controller->recall(*found);
        });
    if (m_settings.savedViews.empty())
        return;
    saved->addSeparator();
    QMenu* gone = addMenu("delete-view", tr("&Delete"), saved);
    for (const SavedView& view : m_settings.savedViews)
        addAction(*gone, "", QString::fromStdString(view.name), {}, [this, name = view.name] {
            std::erase_if(m_settings.savedViews, [&](const SavedView& each) { return each.name == name; });
        });
}

void MainWindow::saveView() {
    auto* dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save the view"));
    dialog->setLabelText(tr("Name; one that exists is replaced"));
    dialog->setTextValue(tr("View %1").arg(m_settings.savedViews.size() + 1));
    const SavedView now = m_controller->savedView({});
    connect(dialog, &QInputDialog::textValueSelected, this, [this, now](const QString& text) {
        SavedView view = now;
        view.name = text.simplified().toStdString();
        if (!view.name.empty())
            keep(m_settings.savedViews, view);
        showSavedViews();
    });
    dialog->open();
}

void MainWindow::buildTrueSurface(QMenu& view) {
    auto* bar = new TruthBar(m_settings.truth, this);
    addToolBar(Qt::BottomToolBarArea, bar);
    QAction* on = addAction(view, "view", tr("&True Surface"), QKeySequence("F6"), [] {});
    on->setObjectName("true-surface-on");
    on->setCheckable(true);
    on->setChecked(m_settings.truth.on);
    on->setToolTip(tr("Where the view rests, rays find the surface itself: it grows out of the splats"));
    connect(on, &QAction::toggled, bar, &TruthBar::setOn);
    connect(bar, &TruthBar::edited, this, [this](const TruthSettings& settings) {
        m_settings.truth = settings;
        m_controller->refresh();
    });
}

void MainWindow::buildClipping(QMenu& view) {
    m_cutBar = new CutBar(this);
    addToolBar(Qt::BottomToolBarArea, m_cutBar);
    m_cutBar->hide();
    QAction* shown = m_cutBar->toggleViewAction();
    shown->setText(tr("&Clipping"));
    shown->setShortcut(QKeySequence("Shift+B"));
    shown->setToolTip(tr("Cut the model open with planes, and see the curves where they meet it"));
    view.addAction(shown);
    const auto follow = [this] {
        m_cutBar->display(m_controller->cuts(), m_editor->snapshot().surface.tree().bounds());
    };
    connect(m_controller, &ViewController::cutsChanged, this, follow);
    connect(m_cutBar, &CutBar::edited, m_controller, &ViewController::setCuts);
    connect(m_cutBar, &CutBar::freeWanted, m_controller, &ViewController::faceFreeCut);
    follow();
}

} // namespace ui
