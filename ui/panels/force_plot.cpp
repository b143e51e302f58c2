#include "ui/panels/force_plot.h"

#include <algorithm>
#include <QPainter>
#include <QPainterPath>

namespace ui {

ForcePlot::ForcePlot(QWidget* parent) : QWidget(parent) {
    setFixedSize(sizeHint());
    setToolTip(tr("The force on the hand over the last seconds; darker where the tool worked"));
}

void ForcePlot::add(double newtons, bool worked) {
    m_forces.push_back({newtons, worked});
    if (m_forces.size() > most)
        m_forces.pop_front();
    update();
}

void ForcePlot::clear() {
    m_forces.clear();
    update();
}

void ForcePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(area, 3, 3);
    double largest = 1;
    for (const Force& each : m_forces)
        largest = std::max(largest, each.newtons);
    const auto place = [&](std::size_t i) {
        return QPointF(area.left() + area.width() * static_cast<double>(i) / (most - 1),
                       area.bottom() - 2 - (area.height() - 4) * m_forces[i].newtons / largest);
    };
    const QColor curve = palette().color(QPalette::Highlight);
    for (std::size_t i = 0; i < m_forces.size(); ++i)
        if (m_forces[i].worked)
            painter.fillRect(QRectF(place(i).x(), area.top() + 1, area.width() / most + 0.5, area.height() - 2),
                             QColor(curve.red(), curve.green(), curve.blue(), 50));
    if (m_forces.size() > 1) {
        QPainterPath path(place(0));
        for (std::size_t i = 1; i < m_forces.size(); ++i)
            path.lineTo(place(i));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(curve, 1.4));
        painter.drawPath(path);
    }
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(area.adjusted(4, 1, -4, 0), Qt::AlignLeft | Qt::AlignTop, tr("%1 N").arg(largest, 0, 'f', 1));
}

} // namespace ui
