// What meets a person who has opened nothing, and the tour. Interface's thread only.
#pragma once

namespace ui {

class MainWindow;

/// The card with what there is to begin with, over the picture; one at a time.
void showStart(MainWindow& window);
/// From its first step.
void showTour(MainWindow& window);
/// Takes away what one of them has put over the picture; false where there is nothing.
bool closeCards(MainWindow& window);

} // namespace ui
