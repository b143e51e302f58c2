#include "ui/viewport/thread_picture.h"

#include "ui/work/post.h"

#include <QPainter>

namespace ui {

ThreadPicture::ThreadPicture(QWidget& widget, Viewport& viewport) : m_widget(widget), m_viewport(viewport) {
    const auto deliver = [this](RenderThread::Result result) {
        post(this, [this, moved = std::move(result)] { receive(moved); });
    };
    m_thread = std::make_unique<RenderThread>(std::make_unique<render::CpuSplatter>(), deliver);
}

ThreadPicture::~ThreadPicture() {
    m_thread.reset(); // before the members that its last frame would reach
}

void ThreadPicture::receive(RenderThread::Result result) {
    if (!result.trouble.isEmpty()) {
        if (m_viewport.troubled)
            m_viewport.troubled(result.trouble);
        return;
    }
    if (m_viewport.refined)
        m_viewport.refined(result.refinement);
    if (result.picture.isNull())
        return;
    m_picture = std::move(result.picture);
    m_picture.setDevicePixelRatio(m_widget.devicePixelRatioF());
    m_input = result.input;
    m_widget.update();
    if (m_viewport.framePainted && !result.refinement && !result.smooth)
        m_viewport.framePainted(result.seconds);
}

bool ThreadPicture::paint(QPainter& painter) const {
    if (m_picture.isNull())
        return false;
    if (m_picture.size() == (QSizeF(m_widget.size()) * m_widget.devicePixelRatioF()).toSize())
        painter.drawImage(QPointF(0, 0), m_picture); // a plain copy; stretching would wait for Qt's thread pool
    else
        painter.drawImage(m_widget.rect(), m_picture); // until the picture for the new size comes
    return true;
}

} // namespace ui
