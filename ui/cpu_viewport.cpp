#include "ui/cpu_viewport.h"

#include <QPainter>

namespace ui {

CpuViewport::CpuViewport(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    const auto deliver = [this](RenderThread::Result result) {
        const auto pass = [this, moved = std::move(result)] { receive(moved); };
        QMetaObject::invokeMethod(this, pass, Qt::QueuedConnection);
    };
    m_thread = std::make_unique<RenderThread>(render::makeRenderer("cpu"), deliver);
}

CpuViewport::~CpuViewport() {
    m_thread.reset(); // before the members that its last frame would reach
}

void CpuViewport::show(const Frame& frame) {
    m_thread->request(frame);
}

void CpuViewport::receive(RenderThread::Result result) {
    if (!result.trouble.isEmpty()) {
        if (troubled)
            troubled(result.trouble);
        return;
    }
    m_picture = std::move(result.picture);
    m_input = result.input;
    update();
    if (framePainted)
        framePainted(result.seconds);
}

void CpuViewport::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_picture.isNull())
        painter.fillRect(rect(), palette().window());
    else if (m_picture.size() == (QSizeF(size()) * devicePixelRatioF()).toSize()) {
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        painter.drawImage(QPointF(0, 0), m_picture); // a plain copy; stretching would wait for Qt's thread pool
    } else
        painter.drawImage(rect(), m_picture); // until the picture for the new size comes
    if (paintOverlay)
        paintOverlay(painter);
    if (shown)
        shown(m_input);
}

} // namespace ui
