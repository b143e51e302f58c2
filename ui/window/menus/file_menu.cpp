#include "core/process/samples/samples.h"
#include "ui/theme/icon.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"
#include "ui/window/mesh_export.h"
#include "ui/window/thumbnails.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>

namespace ui {

static void addNewMenu(MainWindow& window, QMenu& file) {
    QMenu* fresh = addMenu(window, "new", QObject::tr("&New"), &file);
    fresh->setIcon(icon("new"));
    for (const auto& row : process::sampleTable()) {
        QAction* action =
            addEntry(*fresh, "model", spoken(row.label), {}, [&window, id = row.id] { window.files().make(id); });
        action->setToolTip(spoken(row.tip));
        action->setData(row.id);
        action->setProperty(inEnglish, QString(row.label));
    }
}

static void showRecent(MainWindow& window, QMenu& recent) {
    const std::vector<std::string>& files = window.settings().recentFiles;
    recent.clear();
    recent.setEnabled(!files.empty());
    for (const std::string& path : files) {
        const QFileInfo file(QString::fromStdString(path));
        QAction* action = recent.addAction(window.thumbnails().of(path), file.fileName());
        action->setToolTip(file.filePath());
        QObject::connect(action, &QAction::triggered, &window,
                         [&window, path] { window.files().open(std::filesystem::path(path)); });
    }
}

static void addRecentMenu(MainWindow& window, QMenu& file) {
    QMenu* recent = addMenu(window, "recent", QObject::tr("Open &Recent"), &file);
    const auto show = [&window, recent] { showRecent(window, *recent); };
    QObject::connect(&window.files(), &FileActions::recentChanged, recent, show);
    show();
}

static void addExports(MainWindow& window, QMenu& file) {
    addEntry(file, "image", QObject::tr("&Export Image…"), QKeySequence("Ctrl+E"),
             [&window] { window.images().ask(); });
    QAction* mesh = addEntry(file, "", QObject::tr("Export &Mesh…"), QKeySequence("Ctrl+Shift+E"), [] {});
    mesh->setCheckable(true);
    mesh->setToolTip(QObject::tr("Triangulates the surface and previews the mesh over the picture"));
    QObject::connect(mesh, &QAction::toggled, &window.meshExport(), &MeshExport::setOpen);
}

void addFileMenu(MainWindow& window) {
    FileActions& files = window.files();
    QMenu* menu = addMenu(window, "file", QObject::tr("&File"));
    addNewMenu(window, *menu);
    addEntry(*menu, "open", QObject::tr("&Open…"), QKeySequence::Open, [&files] { files.open(); });
    addEntry(*menu, "", QObject::tr("Open &With…"), QKeySequence("Ctrl+Alt+O"), [&files] { files.openWith(); })
        ->setToolTip(QObject::tr("With a say in what is made of it: columns of a text, unit, upwards, thinning, "
                                 "sampling of faces, sharp edges, the surface"));
    addRecentMenu(window, *menu);
    addEntry(*menu, "", QObject::tr("&Add Model…"), QKeySequence("Ctrl+Shift+O"), [&files] {
        files.add();
    })->setToolTip(QObject::tr("Puts the models of a file beside what is open"));
    menu->addSeparator();
    addEntry(*menu, "save", QObject::tr("&Save"), QKeySequence::Save, [&files] { files.save(); });
    addEntry(*menu, "save-as", QObject::tr("Save &As…"), QKeySequence("Ctrl+Shift+S"), [&files] { files.saveAs(); });
    addEntry(*menu, "", QObject::tr("Save Next &Version"), QKeySequence("Ctrl+Alt+S"), [&files] {
        files.saveVersion();
    })->setToolTip(QObject::tr("Beside the last one, with the next number in its name; work goes on in it"));
    addEntry(*menu, "", QObject::tr("Save a Cop&y…"), {}, [&files] {
        files.saveCopy();
    })->setToolTip(QObject::tr("Work goes on in the file that is open"));
    addExports(window, *menu);
    menu->addSeparator();
    addEntry(*menu, "", QObject::tr("&Run Session…"), {}, [&files] {
        files.runSession();
    })->setToolTip(QObject::tr("Executes the commands of a session file, line by line"));
    addEntry(*menu, "", QObject::tr("Save Sessio&n…"), {}, [&files] {
        files.saveSession();
    })->setToolTip(QObject::tr("Writes all that was done since the model was opened, as a session to run again"));
    menu->addSeparator();
    addEntry(*menu, "recover", QObject::tr("Re&cover Lost Work…"), {}, [&window, &files] {
        if (!files.offerRecovery())
            window.tell(QObject::tr("No other lost work was found."));
    });
    menu->addSeparator();
    addEntry(*menu, "quit", QObject::tr("&Close"), QKeySequence("Ctrl+Q"), [&window] { window.close(); });
}

} // namespace ui
