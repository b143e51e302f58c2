// What is done to the mask as a whole, for hands that sculpt: an entry and a key each, and a pie of all of them.
#include "ui/panels/pie_menu.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <nlohmann/json.hpp>
#include <QAction>
#include <QCursor>
#include <QMenu>

namespace ui {

namespace {

struct MaskRow {
    const char *id, *label, *key, *tip;
    bool byLength = false; ///< of half the brush, as steps of selections
};
/// In the order of the pie: what is opposite does the opposite.
constexpr MaskRow rows[] = {
    {"invert", QT_TR_NOOP("&Invert"), "Ctrl+I", QT_TR_NOOP("What is masked becomes free, and the other way round")},
    {"grow", QT_TR_NOOP("&Grow"), "", QT_TR_NOOP("Farther along the surface, by half the brush"), true},
    {"sharpen", QT_TR_NOOP("&Sharpen"), "", QT_TR_NOOP("A harder border"), true},
    {"cavity", QT_TR_NOOP("From &Hollows"), "", QT_TR_NOOP("Masks hollows as wide as half the brush"), true},
    {"clear", QT_TR_NOOP("&Clear"), "Alt+M", QT_TR_NOOP("All is free")},
    {"shrink", QT_TR_NOOP("Sh&rink"), "", QT_TR_NOOP("Less far along the surface, by half the brush"), true},
    {"blur", QT_TR_NOOP("&Blur"), "", QT_TR_NOOP("A softer border"), true},
    {"copy", QT_TR_NOOP("From Se&lection"), "", QT_TR_NOOP("Masks what is selected")},
};

void change(MainWindow& window, const MaskRow& row) {
    SculptView& view = window.sculptView();
    nlohmann::json command{{"op", "mask"}, {"do", row.id}};
    if (row.byLength)
        command["length"] = 0.5 * view.sizing().radiusAt(view.motion().view().target);
    window.editor().run(command);
}

} // namespace

void addMaskMenu(MainWindow& window) {
    QMenu* menu = addMenu(window, "mask", QObject::tr("Mas&k"));
    QList<QAction*> all;
    for (const MaskRow& row : rows) {
        QAction* action = addEntry(*menu, "", QObject::tr(row.label), QKeySequence(row.key),
                                   [&window, &row] { change(window, row); });
        action->setData(QString("mask-%1").arg(row.id));
        action->setObjectName(action->data().toString());
        action->setToolTip(QObject::tr(row.tip));
        all << action;
    }
    menu->addSeparator();
    QAction* pie = addEntry(*menu, "", QObject::tr("&Pie of These"), QKeySequence("A"), [&window, all] {
        QWidget& canvas = *window.viewport().widget();
        new PieMenu(canvas, canvas.mapFromGlobal(QCursor::pos()), all);
    });
    pie->setAutoRepeat(false); // its key may be held
    pie->setToolTip(QObject::tr("All of these around the pointer: move towards one, and click or let the key go"));
}

} // namespace ui
