#include "ui/panels/colour_field.h"

#include <QColorDialog>
#include <QPainter>

namespace ui {

ColourField::ColourField(const QString& label, QWidget* parent) : QToolButton(parent) {
    setObjectName("plain");
    setText(label);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setIconSize({16, 16});
    connect(this, &QToolButton::clicked, this, &ColourField::ask);
}

void ColourField::setColour(const QColor& colour) {
    m_colour = colour;
    QPixmap swatch(16, 16);
    swatch.fill(Qt::transparent);
    QPainter painter(&swatch);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(colour);
    painter.setPen(QColor(0, 0, 0, 160));
    painter.drawRoundedRect(QRectF(1, 1, 14, 14), 3, 3);
    painter.end();
    setIcon(swatch);
}

void ColourField::choose(const QColor& colour) {
    if (!colour.isValid() || colour == m_colour)
        return;
    setColour(colour);
    Q_EMIT edited();
}

void ColourField::ask() {
    choose(QColorDialog::getColor(m_colour, this, text()));
}

} // namespace ui
