// The bars over the lower edge of the picture that the View menu shows: those of the true surface, the clip planes,
// layers and touch.
#include "ui/panels/cut_bar.h"
#include "ui/panels/layer_bar.h"
#include "ui/panels/touch_bar.h"
#include "ui/panels/truth_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>

namespace ui {

void addTruthBar(MainWindow& window, QMenu& view) {
    auto* bar = new TruthBar(window.settings().truth, &window);
    window.bars().add(*bar);
    QAction* on = addEntry(view, "view", QObject::tr("&True Surface"), QKeySequence("F6"), [] {});
    on->setObjectName("true-surface-on");
    on->setCheckable(true);
    on->setChecked(window.settings().truth.on);
    on->setToolTip(QObject::tr("Rays find the surface itself wherever the view rests; it grows out of the splats; "
                               "glass, metal and shadows are in its bar"));
    QObject::connect(on, &QAction::toggled, bar, &TruthBar::setOn);
    QObject::connect(bar, &TruthBar::edited, &window, [&window](const TruthSettings& settings) {
        window.settings().truth = settings;
        window.sculptView().refresh();
    });
}

void addCutBar(MainWindow& window, QMenu& view) {
    auto* bar = new CutBar(&window);
    bar->hide();
    window.bars().add(*bar, [bar](int width) { bar->fitInto(width); });
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

void addLayerBar(MainWindow& window, QMenu& view) {
    auto* bar = new LayerBar(&window);
    bar->hide();
    window.bars().add(*bar, [bar](int width) { bar->fitInto(width); });
    QAction* shown = bar->toggleViewAction();
    shown->setText(QObject::tr("&Layers"));
    shown->setShortcut(QKeySequence("Shift+L"));
    shown->setToolTip(QObject::tr("Keep strokes apart in layers, of which more or less is shown"));
    view.addAction(shown);
    QObject::connect(&window.editor(), &Editor::changed, bar,
                     [&window, bar] { bar->display(window.editor().snapshot().layers); });
    QObject::connect(bar, &LayerBar::wanted, &window,
                     [&window](const nlohmann::json& command) { window.editor().run(command); });
    QObject::connect(bar, &LayerBar::nameWanted, &window, [&window](const QString& now) {
        bool taken = false;
        const QString next = QInputDialog::getText(&window, QObject::tr("Rename Layer"), QObject::tr("Name:"),
                                                   QLineEdit::Normal, now, &taken);
        if (taken && next != now)
            window.editor().run(
                {{"op", "layer"}, {"do", "rename"}, {"name", now.toStdString()}, {"to", next.trimmed().toStdString()}});
    });
    bar->display(window.editor().snapshot().layers);
}

void addTouchBar(MainWindow& window, QMenu& view) {
    auto* bar = new TouchBar(&window);
    bar->hide();
    window.bars().add(*bar);
    QAction* shown = bar->toggleViewAction();
    shown->setText(QObject::tr("Touc&h"));
    shown->setShortcut(QKeySequence("F7"));
    shown->setToolTip(
        QObject::tr("Feel the model with a haptic device, a mouse or a simulated hand, and sculpt by touch"));
    view.addAction(shown);
    TouchInput& touch = window.sculptView().touch();
    QObject::connect(bar, &TouchBar::edited, &touch, &TouchInput::set);
    QObject::connect(&touch, &TouchInput::stopped, bar, &TouchBar::turnOff);
    QObject::connect(&touch, &TouchInput::felt, bar, [&touch, bar] {
        bar->showForce(length(touch.look().force), touch.look().works);
        bar->showState(touch.state());
    });
    QObject::connect(shown, &QAction::toggled, &touch, [&touch](bool on) {
        if (!on)
            touch.stop();
    });
}

} // namespace ui
