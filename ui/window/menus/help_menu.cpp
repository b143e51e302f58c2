#include "ui/theme/icon.h"
#include "ui/window/command_palette.h"
#include "ui/window/keys_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/manual_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"
#include "ui/window/shortcuts_dialog.h"
#include "ui/window/welcome.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

namespace ui {

static void showShortcuts(MainWindow& window) {
    auto* dialog = new ShortcutsDialog(window, &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

static void showAbout(MainWindow& window) {
    auto* box = new QMessageBox(&window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(QObject::tr("About Pointclay"));
    box->setIconPixmap(icon("pointclay").pixmap(64, 64));
    box->setText(QObject::tr("<b>Pointclay %1</b><br>Sculpts and edits point-set surfaces.")
                     .arg(QCoreApplication::applicationVersion()));
    box->setInformativeText(QObject::tr("Drawn by: %1 (%2).<br>Free software under the GNU General Public License, "
                                        "version 3 or later.")
                                .arg(window.viewport().rendererName(), window.whyRenderer()));
    box->open();
}

void addHelpMenu(MainWindow& window) {
    QMenu* help = addMenu(window, "help", QObject::tr("Hel&p"));
    QAction* find = addEntry(*help, "keyboard", QObject::tr("&Find an Action…"), QKeySequence("F3"), [&window] {
        auto* palette = new CommandPalette(*window.menuBar(), &window);
        palette->setAttribute(Qt::WA_DeleteOnClose);
        palette->open();
    });
    find->setShortcuts({QKeySequence("F3"), QKeySequence("Ctrl+K")});
    find->setToolTip(QObject::tr("Every action of every menu, by a few letters of its name"));
    addEntry(*help, "manual", QObject::tr("&Manual"), QKeySequence("F1"), [&window] {
        auto* manual = new ManualWindow(manualFile(), &window);
        manual->setAttribute(Qt::WA_DeleteOnClose);
        manual->show();
    })->setToolTip(QObject::tr("First steps, every tool, every command"));
    addEntry(*help, "", QObject::tr("&Tour"), {}, [&window] {
        showTour(window);
    })->setToolTip(QObject::tr("Two minutes with your own hands"));
    addEntry(*help, "", QObject::tr("Start &Card"), {}, [&window] {
        showStart(window);
    })->setToolTip(QObject::tr("A model to open, samples, what was open lately"));
    addEntry(*help, "keyboard", QObject::tr("&Shortcuts…"), QKeySequence("Shift+F1"),
             [&window] { showShortcuts(window); });
    addEntry(*help, "keyboard", QObject::tr("Edit &Keys…"), {}, [&window] {
        auto* dialog = new KeysDialog(*window.menuBar(), window.settings().keys, &window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    })->setToolTip(QObject::tr("Another key for any action of the menus"));
    addEntry(*help, "about", QObject::tr("&About Pointclay…"), {}, [&window] { showAbout(window); });
}

} // namespace ui
