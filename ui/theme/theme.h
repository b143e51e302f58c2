// The look: one dark palette and one small style sheet, the same on every desktop.
#pragma once

class QApplication;

namespace ui {

void applyTheme(QApplication& application);

} // namespace ui
