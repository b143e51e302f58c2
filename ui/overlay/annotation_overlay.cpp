#include "ui/overlay/annotation_overlay.h"

#include "ui/words/words.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

namespace ui {

static QColor colourOf(const base::Vec3f& c) {
    return QColor::fromRgbF(c.x, c.y, c.z);
}

/// The outline of letters and lines, which makes them legible on anything.
static QColor outlineOf(const base::Vec3f& c) {
    return c.x + c.y + c.z > 1.2f ? QColor(13, 13, 15, 120) : QColor(255, 255, 255, 150);
}

/// Titles are words; numbers and the axes' letters are the same in every language.
static QString wordsOf(const std::string& text) {
    const bool words = text.size() > 1 && QChar(text.front()).isLetter();
    return words ? spoken(text, "legend") : QString::fromStdString(text);
}

static void paintText(QPainter& painter, const render::DrawnText& text) {
    QFont font = painter.font();
    font.setPixelSize(std::max(6, qRound(text.capHeight * 1.4f))); // capitals are some 0.7 of a font's size
    const QFontMetricsF metrics(font);
    const QString words = wordsOf(text.text);
    const double x = text.at.x - text.anchor * metrics.horizontalAdvance(words);
    QPainterPath path;
    path.addText(QPointF(x, text.at.y), font, words);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(outlineOf(text.colour), 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.fillPath(path, colourOf(text.colour));
}

static void paintRamp(QPainter& painter, const render::DrawnRamp& ramp) {
    const int rows = std::max(1, qRound(ramp.height));
    for (int row = 0; row < rows; ++row) {
        const surfel::Colour c =
            render::mapped(ramp.map, 1 - (static_cast<float>(row) + 0.5f) / static_cast<float>(rows));
        painter.fillRect(QRectF(ramp.corner.x, ramp.corner.y + static_cast<float>(row), ramp.width, 1),
                         QColor(int(c & 255u), int(c >> 8 & 255u), int(c >> 16 & 255u)));
    }
}

void paint(QPainter& painter, const render::Drawing& drawing) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const render::DrawnRamp& ramp : drawing.ramps)
        paintRamp(painter, ramp);
    for (const render::DrawnLine& line : drawing.lines)
        for (const bool outline : {true, false}) {
            painter.setPen(QPen(outline ? outlineOf(line.colour) : colourOf(line.colour),
                                line.width + (outline ? 2 : 0), Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(QPointF(line.from.x, line.from.y), QPointF(line.to.x, line.to.y));
        }
    for (const render::DrawnText& text : drawing.texts)
        paintText(painter, text);
    painter.restore();
}

} // namespace ui
