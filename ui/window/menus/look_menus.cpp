#include "core/render/effects/effect_rows.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {

static void addShadingMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "shading", QObject::tr("&Shading"), &view);
    auto* one = new QActionGroup(menu);
    const char* group = nullptr;
    for (const auto& row : render::shadingTable()) {
        if (!group || std::string_view(group) != row.group)
            menu->addSection(QObject::tr(row.group));
        group = row.group;
        addChoice(*menu, *one, row, row.shading == window.settings().shading, [&window, shading = row.shading] {
            window.settings().shading = shading;
            window.measure();
            window.sculptView().refresh();
        });
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
    });
}

static void addEffectsMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "effects", QObject::tr("&Effects"), &view);
    stayOpen(*menu);
    for (const auto& row : render::effectTable())
        addBit(window, *menu, row, std::uint32_t(row.effect), window.settings().effects);
}

static void addAroundMenu(MainWindow& window, QMenu& view) {
    QMenu* menu = addMenu(window, "around", QObject::tr("&Around the Model"), &view);
    stayOpen(*menu);
    addSwitch(*menu, "grid", QObject::tr("Ground Grid"), QObject::tr("Lines at round coordinates below the model"),
              window.settings().grid, [&window](bool on) {
                  window.settings().grid = on;
                  window.sculptView().refresh();
              });
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
