// Trimming with the pointer: an outline drawn over the picture cuts straight through the model. One outline at a time,
// then the pointer sculpts again. Interface's thread only.
#pragma once

class QMenu;

namespace ui {

class MainWindow;

/// A submenu with an entry for each shape of outlines. The window outlives it.
void addTrimMenu(MainWindow& window, QMenu& menu);

} // namespace ui
