// Where the window looks from: its view and camera, and all that moves them but flying (flight.h). Interface's thread
// only. Pixels are device pixels.
#pragma once

#include "core/render/named_views.h"
#include "ui/interaction/cut_planes.h"
#include "ui/interaction/navigator.h"
#include "ui/view/saved_views.h"

#include <QPointF>

class QWidget;

namespace ui {

class ViewMotion : public QObject {
    Q_OBJECT
  public:
    /// `canvas` has the picture's size; all outlive it.
    ViewMotion(const Editor& editor, const CutPlanes& cuts, const QWidget& canvas, QObject* parent = nullptr);

    Navigator& navigator() { return m_navigator; }
    const Navigator& navigator() const { return m_navigator; }
    /// Where the view is or is smoothly going to be, and its camera: what picking and strokes use.
    const View& view() const { return m_navigator.view(); }
    render::Camera camera() const { return cameraOf(m_navigator.view()); }
    /// What the picture shows on the way there.
    render::Camera shownCamera() const { return cameraOf(m_navigator.shown()); }
    double pixelsPerUnitAt(const base::Vec3d& place) const; ///< pixels per model unit

    void orbit(const QPointF& fromPx, const QPointF& toPx);
    void pan(const QPointF& byPx);

    /// For another model, at once: all of it, from the front, a little from the right and above.
    void showNewModel();
    void frameAll();
    void frame(std::span<const base::Box3f> boxes);
    void turnTo(const render::NamedView& view);
    /// To the named view from there: an axis of the model.
    void lookFrom(const base::Vec3d& toEye);
    /// Another axis of the model is upwards: all of it, seen from the same side as it now stands.
    void stand(base::UpAxis up);
    /// Coordinates are others from now on: `motion` takes those of before to them. The picture stays.
    void follow(const process::Rigid& motion);
    void toggleParallel();
    SavedView savedView(const std::string& name) const;
    void recall(const SavedView& view);

  Q_SIGNALS:
    void moved(bool more); ///< the picture is another one; `more` will follow at once
    void changed();        ///< projection or flight, for what shows them

  private:
    render::Camera cameraOf(const View& view) const;

    const Editor& m_editor;
    const CutPlanes& m_cuts;
    const QWidget& m_canvas;
    Navigator m_navigator;
};

} // namespace ui
