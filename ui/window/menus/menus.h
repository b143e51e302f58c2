// The menus of the main window, one function for each in a file of its name, in the order of the menu bar: loops over
// tables wherever there is one. Each makes its menu and connects it; what entries do is elsewhere.
//
// A menu is found by its object name: "file", "new", "recent", "edit", "brush", "model", "select", "mask", "measure",
// "view", "shading", "attribute", "background", "effects", "around", "saved-views", "navigation", "theme", "help".
// Interface's thread only.
#pragma once

class QMenu;

namespace ui {

class MainWindow;

void addFileMenu(MainWindow& window);
void addEditMenu(MainWindow& window);
void addBrushMenu(MainWindow& window);
void addModelMenu(MainWindow& window);
void addSelectMenu(MainWindow& window);
void addMaskMenu(MainWindow& window);
void addMeasureMenu(MainWindow& window);
void addViewMenu(MainWindow& window);
void addHelpMenu(MainWindow& window);

// Parts of the View menu.
void addLookMenus(MainWindow& window, QMenu& view);   ///< shading, background, effects, what stands around
void addViewEntries(MainWindow& window, QMenu& view); ///< framing, named views, projection
void addSavedViewsMenu(MainWindow& window, QMenu& view);
void addThemeMenu(MainWindow& window, QMenu& view);
void addNavigationMenu(MainWindow& window, QMenu& view); ///< styles, pivot, flight
/// The bars over the picture, and the entries that show them.
void addTruthBar(MainWindow& window, QMenu& view);
void addCutBar(MainWindow& window, QMenu& view);
void addLayerBar(MainWindow& window, QMenu& view);
void addTouchBar(MainWindow& window, QMenu& view);

/// What is wanted most often, for hands that hold a pen: in the corner of the menu bar, after all menus.
void addCornerBar(MainWindow& window);

} // namespace ui
