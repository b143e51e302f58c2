// Handles over the picture that hands drag (view/placement.h). While it is on, a press on one of them is its;
// everything else goes on as ever. What is moved by that is its owner's. Interface's thread only.
#pragma once

#include "ui/interaction/view_motion.h"
#include "ui/view/placement.h"

#include <QEvent>

class QPainter;

namespace ui {

class PlacementTool : public QObject {
    Q_OBJECT
  public:
    /// Both outlive it. Its events are taken before those of filters that were installed earlier.
    PlacementTool(const ViewMotion& motion, QWidget& canvas, QObject* parent = nullptr);

    /// About a place of the stored coordinates.
    void begin(const base::Vec3d& middle);
    void end();
    bool on() const { return m_on; }
    /// The pointer is over a handle, or drags one.
    bool held() const { return m_drag || m_under; }
    bool dragging() const { return m_drag.has_value(); }
    const Placement& placement() const { return m_placement; }
    /// As somebody has typed it.
    void set(const Placement& placement);
    /// The drag in progress is as if it had not been; false where there was none.
    bool cancel();
    /// Where the handles stand now.
    base::Vec3d middle() const { return m_middle + m_placement.move; }
    void paint(QPainter& painter, const render::Camera& seen) const;
    /// Of arrows, device pixels.
    double lengthPx() const;

  Q_SIGNALS:
    void changed(); ///< by a drag

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    /// A mouse or a pen; true: it was about a handle.
    bool hand(QEvent::Type what, const QPointF& at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    std::optional<Handle> under(const QPointF& pixel) const;

    const ViewMotion& m_motion;
    QWidget& m_canvas;
    bool m_on = false;
    base::Vec3d m_middle; ///< without any move
    Placement m_placement;
    std::optional<HandleDrag> m_drag;
    std::optional<Handle> m_under; ///< the pointer
};

} // namespace ui
