// The OpenGL viewport: the blended splatter in a QOpenGLWidget's framebuffer, the overlay painted over it.
//
// While the view moves, a DetailPacer keeps frames within a budget; when it rests, the picture settles to its best. The
// true surface, if asked for, is drawn on the CPU and laid over it.
//
// Construct it only where `glUsable` says so: on some platforms a QOpenGLWidget crashes when shown.
#pragma once

#include "core/render/splats/detail_pacer.h"
#include "ui/viewport/thread_picture.h"

#include <memory>
#include <QOpenGLWidget>
#include <QTimer>

namespace render {
class GlSplatter;
}

namespace ui {

/// Whether this platform makes a context in which the splatter works; it is made, tried and dropped. `why` receives
/// the driver's name, or what is missing. A software driver counts as usable only where `software` allows it: the CPU
/// splatter is several times faster than that.
bool glUsable(bool software, QString& why);

class GlViewport : public QOpenGLWidget, public Viewport {
    Q_OBJECT
  public:
    explicit GlViewport(QWidget* parent = nullptr);
    ~GlViewport() override;

    QWidget* widget() override { return this; }
    QString rendererName() const override { return m_name; }
    void show(const Frame& frame) override;
    QImage picture() override;
    using QOpenGLWidget::show;

  protected:
    void initializeGL() override;
    void paintGL() override;

  private:
    void dropSplatter();
    void drawSplats();
    bool showsTruth() const { return m_truth && m_frame.truth && !m_truth->picture().isNull(); }
    float detailPx() const;

    QString m_name = "OpenGL";
    Frame m_frame;
    render::DetailPacer m_pacer{0.016};
    float m_lastDetail = 0;
    bool m_settling = false;
    QTimer m_rest;                                  ///< runs while a coarse picture waits for the view to rest
    std::unique_ptr<render::GlSplatter> m_splatter; ///< lives while its context does
    bool m_withOverlay = true;
    std::unique_ptr<ThreadPicture> m_truth; ///< while frames ask for the true surface
};

} // namespace ui
