#include "ui/theme/theme.h"
#include "ui/window/docks.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"
#include "ui/words/language.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>

namespace ui {

void addViewEntries(MainWindow& window, QMenu& view) {
    SculptView& scene = window.sculptView();
    ViewMotion& motion = scene.motion();
    addEntry(view, "frame", QObject::tr("Frame &All"), QKeySequence("Home"), [&motion] {
        motion.frameAll();
    })->setObjectName("frame-all");
    addEntry(view, "frame", QObject::tr("Frame &Selection"), QKeySequence("."), [&scene] {
        scene.frameSelection();
    })->setToolTip(QObject::tr("What is selected; else what is not masked; else what is under the brush"));
    for (const auto& row : render::namedViews())
        addEntry(view, "view", spoken(row.label, "view"), QKeySequence(row.shortcut), [&motion, &row] {
            motion.turnTo(row);
        })->setProperty(inEnglish, QString(row.label));
    addEntry(view, "view", QObject::tr("&Turn the Up Axis"), QKeySequence("U"), [&window] {
        const char* next = base::upRow(nextUp(window.editor().snapshot().up)).id;
        window.editor().run({{"op", "up"}, {"axis", next}});
    })->setToolTip(QObject::tr("The next axis upwards: y, z, -y, -z, x, -x; it is kept with the model"));
    QAction* parallel =
        addEntry(view, "view", QObject::tr("&Orthographic"), QKeySequence("5"), [&motion] { motion.toggleParallel(); });
    parallel->setCheckable(true);
    parallel->setToolTip(QObject::tr("Parallel projection: no perspective"));
    QObject::connect(&motion, &ViewMotion::changed, parallel,
                     [&motion, parallel] { parallel->setChecked(motion.view().parallel); });
}

void addNavigationMenu(MainWindow& window, QMenu& view) {
    SculptView& scene = window.sculptView();
    QMenu* menu = addMenu(window, "navigation", QObject::tr("&Navigation"), &view);
    auto* one = new QActionGroup(menu);
    for (const NavigationRow& row : navigationTable())
        addChoice(*menu, *one, row, &row == &navigation(window.settings().navigation), [&window, &scene, &row] {
            window.settings().navigation = row.id;
            scene.motion().navigator().chooseStyle(row);
        });
    menu->addSeparator();
    addEntry(*menu, "", QObject::tr("&Pivot Under the Pointer"), QKeySequence("O"),
             [&scene] { scene.pointer().pickPivot(); })
        ->setToolTip(
            QObject::tr("Turn about the place under the pointer; beside the model, about the middle of the view"));
    QAction* fly =
        addEntry(*menu, "", QObject::tr("&Fly"), QKeySequence("F4"), [&scene] { scene.pointer().takeOff(); });
    fly->setShortcuts({QKeySequence("F4"), QKeySequence("Shift+`"), QKeySequence("Shift+~")});
    fly->setToolTip(QObject::tr("Move with W A S D, Q and E, look with the pointer; Esc lands"));
}

void addThemeMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "theme", QObject::tr("T&heme"), &view);
    auto* one = new QActionGroup(menu);
    for (const ThemeRow& row : themeTable())
        addChoice(*menu, *one, row, row.id == window.settings().theme, [&window, &row] {
            window.settings().theme = row.id;
            applyTheme(*qApp, row.id);
        });
}

static void addLanguageMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "language", QObject::tr("Language"), &view);
    auto* one = new QActionGroup(menu);
    for (const LanguageRow& row : languageTable())
        addChoice(*menu, *one, row, row.id == window.settings().language, [&window, &row] {
            window.settings().language = row.id;
            window.tell(QObject::tr("The window speaks it from the next start on."));
        });
}

/// Which renderer draws, for information only.
static void addRenderer(MainWindow& window, QMenu& view) {
    QAction* renderer = view.addAction(QString());
    renderer->setEnabled(false);
    renderer->setToolTip(window.whyRenderer());
    const auto show = [&window, renderer] {
        renderer->setText(QObject::tr("Drawn by: %1").arg(window.viewport().rendererName()));
    };
    QObject::connect(&view, &QMenu::aboutToShow, renderer, show);
    show();
}

static void addSceneEntry(MainWindow& window, QMenu& view) {
    QAction* scene = window.findChild<QDockWidget*>("scene")->toggleViewAction();
    scene->setText(QObject::tr("&Models"));
    scene->setShortcut(QKeySequence("Ctrl+Shift+M"));
    scene->setToolTip(QObject::tr("All models of the scene: which is active, shown, locked"));
    view.addAction(scene);
}

void addViewMenu(MainWindow& window) {
    QMenu* view = addMenu(window, "view", QObject::tr("&View"));
    addLookMenus(window, *view);
    addTruthBar(window, *view);
    view->addSeparator();
    addViewEntries(window, *view);
    addSavedViewsMenu(window, *view);
    addNavigationMenu(window, *view);
    addCutBar(window, *view);
    addSceneEntry(window, *view);
    addLayerBar(window, *view);
    addTouchBar(window, *view);
    addThemeMenu(window, *view);
    addLanguageMenu(window, *view);
    addSwitch(*view, "left-handed", QObject::tr("Le&ft-handed"), QObject::tr("Tools on the right, panels on the left"),
              window.settings().leftHanded, [&window](bool on) {
                  window.settings().leftHanded = on;
                  layOut(window, on);
              });
    view->addSeparator();
    addRenderer(window, *view);
}

} // namespace ui
