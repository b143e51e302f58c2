// What stands beside the viewport where a person wants it: history and console. Docks can be moved, floated and closed,
// and the window remembers where they are.
#pragma once

namespace ui {

class MainWindow;

/// Tools on one side, panels on the other: for hands that hold the pen in the left, and for all others.
void layOut(MainWindow& window, bool leftHanded);
void addDocks(MainWindow& window);

} // namespace ui
