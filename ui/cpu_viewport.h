// The viewport that needs no GPU: a plain widget that shows what a RenderThread with the CPU splatter draws.
#pragma once

#include "ui/render_thread.h"

#include <QWidget>

namespace ui {

class CpuViewport : public QWidget, public Viewport {
    Q_OBJECT
  public:
    explicit CpuViewport(QWidget* parent = nullptr);
    ~CpuViewport() override;

    QWidget* widget() override { return this; }
    QString rendererName() const override { return "CPU"; }
    void show(const Frame& frame) override;
    QImage picture() override { return m_picture; }
    using QWidget::show;

  protected:
    void paintEvent(QPaintEvent*) override;

  private:
    void receive(RenderThread::Result result);

    QImage m_picture;
    std::uint64_t m_input = 0; ///< that it shows
    std::unique_ptr<RenderThread> m_thread;
};

} // namespace ui
