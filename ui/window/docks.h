// What stands beside the viewport where a person wants it: history and console. Docks can be moved, floated and closed,
// and the window remembers where they are.
#pragma once

namespace ui {

class MainWindow;

void addDocks(MainWindow& window);

} // namespace ui
