// Shows in a widget what a RenderThread draws: all of the CPU viewport, and the true surface of the OpenGL one.
// Interface's thread only.
#pragma once

#include "ui/viewport/viewport.h"
#include "ui/work/render_thread.h"

#include <QWidget>

namespace ui {

class ThreadPicture : public QObject {
    Q_OBJECT
  public:
    /// Both outlive it. The viewport is told of trouble, times and refinement; the widget repaints itself.
    ThreadPicture(QWidget& widget, Viewport& viewport);
    ~ThreadPicture() override;

    void show(const Frame& frame) { m_thread->request(frame); }
    /// False before the first frame.
    bool paint(QPainter& painter) const;
    const QImage& picture() const { return m_picture; }
    std::uint64_t input() const { return m_input; } ///< that it shows

  private:
    void receive(RenderThread::Result result);

    QWidget& m_widget;
    Viewport& m_viewport;
    QImage m_picture;
    std::uint64_t m_input = 0;
    std::unique_ptr<RenderThread> m_thread;
};

} // namespace ui
