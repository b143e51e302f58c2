// A dialog keeps its size while what it says becomes longer, and its rows would lie over each other.
#pragma once

class QDialog;

namespace ui {

/// As high as what it says needs from now on, as far as the screen has room; never lower than it was.
void growToWords(QDialog& dialog);

} // namespace ui
