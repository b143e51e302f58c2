// Where the model is seen: one interface over the two ways to draw it. Input and overlay are the
// SculptView's; a viewport only shows frames and calls back.
#pragma once

#include "ui/work/frame.h"

#include <functional>
#include <memory>
#include <QImage>
#include <QString>

class QPainter;
class QWidget;

namespace ui {

/// Interface's thread only.
class Viewport {
  public:
    virtual ~Viewport() = default;
    virtual QWidget* widget() = 0;
    virtual QString rendererName() const = 0;
    /// Shows the frame soon; a later request replaces one that waits.
    virtual void show(const Frame& frame) = 0;
    /// What is on the screen, without the overlay; null before the first frame.
    virtual QImage picture() = 0;

    std::function<void(QPainter&)> paintOverlay;                   ///< over each picture, in widget coordinates
    std::function<void(double)> framePainted;                      ///< seconds that the renderer took
    std::function<void(std::uint64_t)> shown;                      ///< on the screen now: Frame::input of the picture
    std::function<void(const std::optional<Refinement>&)> refined; ///< of what is shown; nothing: splats
    std::function<void(const QString&)> troubled;                  ///< the renderer failed: what a person should read
};

/// A viewport of plain CPU, or of OpenGL where it is safe to construct one (ui/README 6). The variable
/// POINTCLAY_RENDERER=gl|cpu decides where it is set; `gl` on a platform where constructing it would crash still
/// gives the CPU. Its widget belongs to `parent`; `why` receives one sentence about the choice.
Viewport* makeViewport(QWidget* parent, QString* why = nullptr);

} // namespace ui
