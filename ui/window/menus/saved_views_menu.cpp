#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>

namespace ui {

/// Asks for a name and keeps the view as it was when asked.
static void saveView(MainWindow& window) {
    auto* dialog = new QInputDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QObject::tr("Save View"));
    dialog->setLabelText(QObject::tr("Name (replaces a saved view of the same name):"));
    dialog->setTextValue(QObject::tr("View %1").arg(window.settings().savedViews.size() + 1));
    const SavedView now = window.sculptView().motion().savedView({});
    QObject::connect(dialog, &QInputDialog::textValueSelected, &window, [&window, now](const QString& text) {
        SavedView view = now;
        view.name = text.simplified().toStdString();
        if (!view.name.empty())
            keep(window.settings().savedViews, view);
    });
    dialog->open();
}

static void addViews(MainWindow& window, QMenu& menu) {
    std::vector<SavedView>& views = window.settings().savedViews;
    ViewMotion& motion = window.sculptView().motion();
    for (const SavedView& view : views)
        addEntry(menu, "view", QString::fromStdString(view.name), {}, [&motion, &views, name = view.name] {
            if (const SavedView* found = findView(views, name))
                motion.recall(*found);
        });
    if (views.empty())
        return;
    menu.addSeparator();
    QMenu* gone = addMenu(window, "delete-view", QObject::tr("&Delete"), &menu);
    for (const SavedView& view : views)
        addEntry(*gone, "", QString::fromStdString(view.name), {}, [&views, name = view.name] {
            std::erase_if(views, [&](const SavedView& each) { return each.name == name; });
        });
}

/// The names, a way to delete each, and a way to add one.
static void show(MainWindow& window, QMenu& menu) {
    qDeleteAll(menu.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
    menu.clear();
    addEntry(menu, "", QObject::tr("&Save View…"), QKeySequence("Ctrl+Shift+V"), [&window] { saveView(window); });
    menu.addSeparator();
    addViews(window, menu);
}

void addSavedViewsMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "saved-views", QObject::tr("Sa&ved Views"), &view);
    QObject::connect(menu, &QMenu::aboutToShow, &window, [&window, menu] { show(window, *menu); });
    show(window, *menu);
}

} // namespace ui
