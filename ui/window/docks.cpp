#include "ui/window/docks.h"

#include "core/base/error.h"
#include "core/session/command.h"
#include "ui/panels/console_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/scene_panel.h"
#include "ui/window/main_window.h"

#include <nlohmann/json.hpp>
#include <QDockWidget>
#include <QToolBar>

namespace ui {

/// Shut until somebody wants it.
static void addDock(MainWindow& window, Qt::DockWidgetArea area, const char* name, const QString& title,
                    QWidget* panel) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(name);
    dock->setWidget(panel);
    window.addDockWidget(area, dock);
    dock->hide();
}

static void addHistory(MainWindow& window) {
    auto* panel = new HistoryPanel(window.settings().historyMib);
    addDock(window, Qt::RightDockWidgetArea, "history", QObject::tr("History"), panel);
    QObject::connect(panel, &HistoryPanel::wanted, &window, [&window, panel](int steps) {
        if (window.editor().busy()) // the list may be behind
            panel->show(window.editor().snapshot());
        else
            window.go(steps);
    });
    QObject::connect(panel, &HistoryPanel::budgetChosen, &window, [&window](int mib) {
        window.settings().historyMib = mib;
        window.editor().setHistoryBudget(std::size_t(mib) << 20);
    });
    const auto show = [&editor = window.editor(), panel] { panel->show(editor.snapshot()); };
    QObject::connect(&window.editor(), &Editor::changed, panel, show);
    show();
}

static void execute(MainWindow& window, ConsolePanel& panel, const QString& line) {
    try {
        const nlohmann::json command = commandOf(line.toStdString());
        const auto go = [&window, command] { window.editor().run(command); };
        if (session::command(command.at("op").get<std::string>()).startsModel)
            window.files().unlessUnsaved(go);
        else
            go();
    } catch (const base::Error& error) {
        panel.showMessage(QString::fromStdString(error.what()));
    }
}

static void addConsole(MainWindow& window) {
    auto* panel = new ConsolePanel;
    addDock(window, Qt::BottomDockWidgetArea, "console", QObject::tr("Console"), panel);
    QObject::connect(panel, &ConsolePanel::entered, &window,
                     [&window, panel](const QString& line) { execute(window, *panel, line); });
    QObject::connect(&window.editor(), &Editor::recorded, panel, &ConsolePanel::showLine);
    QObject::connect(&window.editor(), &Editor::told, panel, &ConsolePanel::showMessage);
    QObject::connect(&window.editor(), &Editor::failed, panel, &ConsolePanel::showMessage);
}

static void addScene(MainWindow& window) {
    auto* panel = new ScenePanel;
    addDock(window, Qt::RightDockWidgetArea, "scene", QObject::tr("Models"), panel);
    const auto run = [&window](const nlohmann::json& command) { window.editor().run(command); };
    QObject::connect(panel, &ScenePanel::wanted, &window, run);
    QObject::connect(panel, &ScenePanel::fileWanted, &window.files(), [&window] { window.files().add(); });
    QObject::connect(&window.sculptView(), &SculptView::modelPicked, &window, [&window, run](const QString& name) {
        run({{"op", "scene"}, {"do", "activate"}, {"name", name.toStdString()}});
        window.tell(QObject::tr("Tools now work on “%1”.").arg(name));
    });
    const auto show = [&window, panel, models = std::size_t(1)]() mutable {
        const Snapshot& now = window.editor().snapshot();
        panel->show(now);
        if (now.scene.size() > 1 && models < 2) // somebody who meets a second model looks for the first
            window.findChild<QDockWidget*>("scene")->show();
        models = now.scene.size();
    };
    QObject::connect(&window.editor(), &Editor::changed, panel, show);
    panel->show(window.editor().snapshot());
}

void layOut(MainWindow& window, bool leftHanded) {
    auto* tools = window.findChild<QToolBar*>("tools");
    const bool toolsShown = tools->isVisibleTo(&window);
    window.addToolBar(leftHanded ? Qt::RightToolBarArea : Qt::LeftToolBarArea, tools);
    tools->setVisible(toolsShown);
    for (const char* name : {"properties", "scene", "history"}) {
        auto* dock = window.findChild<QDockWidget*>(name);
        const bool shown = dock->isVisibleTo(&window);
        window.addDockWidget(leftHanded ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, dock);
        dock->setVisible(shown);
    }
}

void addDocks(MainWindow& window) {
    addScene(window);
    addHistory(window);
    addConsole(window);
}

} // namespace ui
