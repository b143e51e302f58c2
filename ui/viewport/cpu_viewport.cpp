#include "ui/viewport/cpu_viewport.h"

#include <QPainter>

namespace ui {

CpuViewport::CpuViewport(QWidget* parent) : QWidget(parent), m_picture(*this, *this) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void CpuViewport::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_picture.paint(painter))
        painter.fillRect(rect(), palette().window());
    if (paintOverlay)
        paintOverlay(painter);
    if (shown)
        shown(m_picture.input());
}

} // namespace ui
