#include "ui/window/grown_dialog.h"

#include <algorithm>
#include <QDialog>
#include <QLayout>
#include <QScreen>

namespace ui {

void growToWords(QDialog& dialog) {
    constexpr int frame = 40;
    const QRect screen = dialog.screen()->availableGeometry();
    const int wanted = std::min(dialog.layout()->totalHeightForWidth(dialog.width()), screen.height() - frame);
    if (wanted <= dialog.height())
        return;
    dialog.resize(dialog.width(), wanted);
    const int below = dialog.geometry().bottom() - screen.bottom();
    if (below > 0)
        dialog.move(dialog.x(), std::max(dialog.y() - below, screen.top()));
}

} // namespace ui
