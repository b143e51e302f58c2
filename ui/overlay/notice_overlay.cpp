#include "ui/overlay/notice_overlay.h"

#include <algorithm>
#include <QPainter>
#include <QPainterPath>

namespace ui {

void paint(QPainter& painter, const Notice& notice, double widthPx, double pixelRatio) {
    if (notice.text.isEmpty())
        return;
    painter.save();
    painter.scale(pixelRatio, pixelRatio);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = widthPx / pixelRatio, top = 12;
    const QFontMetrics metrics = painter.fontMetrics();
    const QString text = metrics.elidedText(notice.text, Qt::ElideMiddle, static_cast<int>(width) - 60);
    const QSizeF size(metrics.horizontalAdvance(text) + 32, metrics.height() + 12);
    const QRectF pill(QPointF((width - size.width()) / 2, top), size);
    QPainterPath outline;
    outline.addRoundedRect(pill, size.height() / 2, size.height() / 2);
    painter.fillPath(outline, QColor(24, 26, 30, 215));
    if (notice.share >= 0) {
        painter.setClipPath(outline);
        QRectF done = pill;
        done.setWidth(pill.width() * std::clamp(notice.share, 0.0, 1.0));
        painter.fillRect(done, QColor(217, 142, 74, 110));
        painter.setClipping(false);
    }
    painter.setPen(QColor(235, 238, 243));
    painter.drawText(pill, Qt::AlignCenter, text);
    painter.restore();
}

} // namespace ui
