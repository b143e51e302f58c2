#include "core/render/effects/effect_rows.h"
#include "ui/panels/view_gizmo.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {

/// Names that the shading of attributes can show; words of layers mean nothing to a person.
static QStringList attributesOf(MainWindow& window) {
    QStringList out;
    for (const surfel::Attribute& each : window.editor().snapshot().surface.tree().layout()->attributes())
        if (!each.name.starts_with("layer_"))
            out << QString::fromStdString(each.name);
    return out;
}

/// The attribute chosen last, else the model's first.
static void showAttribute(MainWindow& window) {
    const QStringList names = attributesOf(window);
    if (names.contains(QString::fromStdString(window.settings().attribute)))
        return;
    window.settings().attribute = names.isEmpty() ? std::string() : names.front().toStdString();
    window.tell(names.isEmpty() ? QObject::tr("This model carries no numbers by name.")
                                : QObject::tr("%1 is shown; the menu has the others.").arg(names.front()));
}

/// Which attribute: made anew each time, since models differ.
static void addAttributeMenu(MainWindow& window, QMenu& shadings, QAction& row) {
    QMenu* menu = addMenu(window, "attribute", QObject::tr("Attribute S&hown"), &shadings);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [&window, menu, &row] {
        menu->clear();
        for (const QString& name : attributesOf(window)) {
            QAction* entry = menu->addAction(name);
            entry->setCheckable(true);
            entry->setChecked(row.isChecked() && name.toStdString() == window.settings().attribute);
            QObject::connect(entry, &QAction::triggered, &row, [&window, name, &row] {
                window.settings().attribute = name.toStdString();
                row.trigger();
            });
        }
        if (menu->isEmpty())
            menu->addAction(QObject::tr("This model carries none"))->setEnabled(false);
    });
}

static void addShadingMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "shading", QObject::tr("&Shading"), &view);
    auto* one = new QActionGroup(menu);
    const char* group = nullptr;
    for (const auto& row : render::shadingTable()) {
        if (!group || std::string_view(group) != row.group)
            menu->addSection(QObject::tr(row.group));
        group = row.group;
        const bool named = row.measure && row.measure->named();
        QAction* choice = addChoice(*menu, *one, row, row.shading == window.settings().shading,
                                    [&window, shading = row.shading, named] {
                                        if (named)
                                            showAttribute(window);
                                        window.settings().shading = shading;
                                        window.measure();
                                        window.sculptView().refresh();
                                    });
        if (named)
            addAttributeMenu(window, *menu, *choice);
    }
}

static void addBackgroundMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "background", QObject::tr("&Background"), &view);
    auto* one = new QActionGroup(menu);
    for (const auto& row : render::backdropTable())
        addChoice(*menu, *one, row, row.backdrop == window.settings().backdrop, [&window, backdrop = row.backdrop] {
            window.settings().backdrop = backdrop;
            window.sculptView().refresh();
        });
}

/// A switch for a bit of `set`, made of a table's row.
template <class Row>
static void addBit(MainWindow& window, QMenu& menu, const Row& row, std::uint32_t bit, std::uint32_t& set) {
    addSwitch(menu, row.id, QObject::tr(row.label), QObject::tr(row.tip), set & bit, [&window, &set, bit](bool on) {
        set = on ? set | bit : set & ~bit;
        window.sculptView().refresh();
    })->setProperty(inEnglish, QString(row.label));
}

static void addEffectsMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "effects", QObject::tr("&Effects"), &view);
    stayOpen(*menu);
    for (const auto& row : render::effectTable())
        addBit(window, *menu, row, std::uint32_t(row.effect), window.settings().effects);
}

static void addGizmo(MainWindow& window, QMenu& menu) {
    auto* gizmo = new ViewGizmo(*window.viewport().widget());
    gizmo->setWanted(window.settings().gizmo);
    addSwitch(menu, "gizmo", QObject::tr("Directions of View"),
              QObject::tr("The model's axes in the corner of the picture, to click and to drag"),
              window.settings().gizmo, [&window, gizmo](bool on) {
                  window.settings().gizmo = on;
                  gizmo->setWanted(on);
              });
    ViewMotion& motion = window.sculptView().motion();
    const auto follow = [gizmo, &motion] {
        const render::Camera seen = motion.shownCamera();
        gizmo->setAxes(seen.right(), seen.upright(), -seen.forward());
    };
    QObject::connect(&window.sculptView(), &SculptView::pictureAsked, gizmo, follow);
    QObject::connect(gizmo, &ViewGizmo::sideWanted, &motion, &ViewMotion::lookFrom);
    QObject::connect(gizmo, &ViewGizmo::dragged, &motion, [&window, &motion](const QPointF& by) {
        constexpr double gain = 3; // it is small
        const QWidget& canvas = *window.viewport().widget();
        const QPointF middle = QRectF(canvas.rect()).center() * canvas.devicePixelRatioF();
        motion.orbit(middle, middle + gain * canvas.devicePixelRatioF() * by);
        window.sculptView().refresh();
    });
    follow();
}

static void addAroundMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "around", QObject::tr("&Around the Model"), &view);
    stayOpen(*menu);
    addSwitch(*menu, "grid", QObject::tr("Ground Grid"), QObject::tr("Lines at round coordinates below the model"),
              window.settings().grid, [&window](bool on) {
                  window.settings().grid = on;
                  window.sculptView().refresh();
              });
    addGizmo(window, *menu);
    addSwitch(*menu, "edges", QObject::tr("Sharp Edges"),
              QObject::tr("Lines along the edges that the model keeps sharp"), window.settings().edges,
              [&window](bool on) {
                  window.settings().edges = on;
                  window.sculptView().edges().show(on);
                  window.sculptView().refresh();
              });
    window.sculptView().edges().show(window.settings().edges);
    for (const auto& row : render::annotationTable())
        addBit(window, *menu, row, std::uint32_t(row.annotation), window.settings().annotated);
}

void addLookMenus(MainWindow& window, QMenu& view) {
    addShadingMenu(window, view);
    addBackgroundMenu(window, view);
    addEffectsMenu(window, view);
    addAroundMenu(window, view);
}

} // namespace ui
