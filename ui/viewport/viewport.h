// Where the model is seen: one interface over the two ways to draw it. Input and overlay are the ViewController's;
// a viewport only shows frames and calls back.
#pragma once

#include "core/raycast/lighting.h"
#include "core/render/renderer.h"
#include "core/render/shading/measured_colours.h"

#include <functional>
#include <memory>
#include <QImage>
#include <QString>

class QPainter;
class QWidget;

namespace ui {

/// The surface itself, to be shown instead of splats as soon as rays have found it.
struct TrueSurface {
    surface::Surface surface; ///< of the frame's model
    double quality = 1;       ///< in pixels (adaptive_cast.h)
    raycast::Lighting lighting;
    std::shared_ptr<const render::Measured> measured; ///< what the shading measures, where it does
};

/// How far a picture of the true surface has come.
struct Refinement {
    double quality = 0; ///< reached, in pixels
    bool complete = false;
    double seconds = 0; ///< since the view rests
    double light = 0;   ///< share of the light found, 0 to 1, once the surface is; it is the last to come
};

/// One picture asked for.
struct Frame {
    tree::SurfelTree model;
    render::Camera camera; ///< its size is the viewport's in device pixels
    render::RenderOptions options;
    bool moving = false;              ///< more will follow at once: speed before quality
    std::optional<TrueSurface> truth; ///< else splats
    /// The last pointer event (ViewController counts them) whose effect it shows.
    std::uint64_t input = 0;
};

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

/// A viewport of plain CPU, or of OpenGL where it is safe to construct one (RENDERING, pitfalls). The variable
/// POINTCLAY_RENDERER=gl|cpu decides where it is set; `gl` on a platform where constructing it would crash still
/// gives the CPU. Its widget belongs to `parent`; `why` receives one sentence about the choice.
Viewport* makeViewport(QWidget* parent, QString* why = nullptr);

} // namespace ui
