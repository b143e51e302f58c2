// The bars over the lower edge of the picture that the View menu shows: the true surface's and the clip planes'.
#include "ui/panels/cut_bar.h"
#include "ui/panels/truth_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QMenu>

namespace ui {

void addTruthBar(MainWindow& window, QMenu& view) {
    auto* bar = new TruthBar(window.settings().truth, &window);
    window.bars().add(*bar);
    QAction* on = addEntry(view, "view", QObject::tr("&True Surface"), QKeySequence("F6"), [] {});
    on->setObjectName("true-surface-on");
    on->setCheckable(true);
    on->setChecked(window.settings().truth.on);
    on->setToolTip(QObject::tr("Rays find the surface itself wherever the view rests; it grows out of the splats"));
    QObject::connect(on, &QAction::toggled, bar, &TruthBar::setOn);
    QObject::connect(bar, &TruthBar::edited, &window, [&window](const TruthSettings& settings) {
        window.settings().truth = settings;
        window.sculptView().refresh();
    });
}

void addCutBar(MainWindow& window, QMenu& view) {
    auto* bar = new CutBar(&window);
    bar->hide();
    window.bars().add(*bar);
    QAction* shown = bar->toggleViewAction();
    shown->setText(QObject::tr("&Clipping"));
    shown->setShortcut(QKeySequence("Shift+B"));
    shown->setToolTip(QObject::tr("Cut the model open with planes and see the curves where they meet the surface"));
    view.addAction(shown);
    SculptView& scene = window.sculptView();
    const auto follow = [&window, &scene, bar] {
        bar->display(scene.cuts().cuts(), window.editor().snapshot().surface.tree().bounds());
    };
    QObject::connect(&scene.cuts(), &CutPlanes::changed, bar, follow);
    QObject::connect(bar, &CutBar::edited, &scene.cuts(), &CutPlanes::set);
    QObject::connect(bar, &CutBar::freeWanted, &scene, &SculptView::faceFreePlane);
    follow();
}

} // namespace ui
