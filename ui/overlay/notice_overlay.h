// A sentence at the upper edge of the picture: what is being opened, what is still working. Device pixels.
#pragma once

#include <QString>

class QPainter;

namespace ui {

/// `share` 0 to 1: how much of the pill is filled; below 0: not known. Nothing is painted for an empty text.
struct Notice {
    QString text;
    double share = -1;

    bool operator==(const Notice&) const = default;
};

/// Centred in `widthPx` device pixels, `pixelRatio` of them to a unit.
void paint(QPainter& painter, const Notice& notice, double widthPx, double pixelRatio);

} // namespace ui
