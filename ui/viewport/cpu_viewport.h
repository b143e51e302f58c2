// The viewport that needs no GPU: a plain widget that shows what a RenderThread draws.
#pragma once

#include "ui/viewport/thread_picture.h"

namespace ui {

class CpuViewport : public QWidget, public Viewport {
    Q_OBJECT
  public:
    explicit CpuViewport(QWidget* parent = nullptr);

    QWidget* widget() override { return this; }
    QString rendererName() const override { return "CPU"; }
    void show(const Frame& frame) override { m_picture.show(frame); }
    QImage picture() override { return m_picture.picture(); }
    using QWidget::show;

  protected:
    void paintEvent(QPaintEvent*) override;

  private:
    ThreadPicture m_picture;
};

} // namespace ui
