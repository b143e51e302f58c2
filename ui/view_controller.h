// What the pointer and the keys do in a viewport, whichever renderer draws it: one event filter, so that input logic
// exists once.
//
//     left on the model      a stroke of the chosen tool; Shift: the smoothing tool, Ctrl: inverted; Esc: as if not
//                            been
//     left beside it, right  orbit (left with Alt: anywhere)
//     middle                 pan
//     wheel                  nearer and farther, towards what lies under the pointer
//     F and moving           radius; [ and ]: in steps
//
// Interface's thread only. Pixels here are device pixels.
#pragma once

#include "ui/brush_cursor.h"
#include "ui/editor.h"
#include "ui/orbit_view.h"
#include "ui/settings.h"
#include "ui/viewport.h"

#include <QElapsedTimer>

class QMouseEvent;
class QTabletEvent;
class QWheelEvent;
class QKeyEvent;

namespace ui {

class ViewController : public QObject {
    Q_OBJECT
  public:
    /// All three outlive the controller.
    ViewController(Editor& editor, Settings& settings, Viewport& viewport, QObject* parent = nullptr);

    void frameAll();
    void turnTo(const NamedView& view);
    /// Radius times `factor`, in whichever unit is chosen.
    void scaleRadius(double factor);
    /// Esc: drops the stroke or the change of radius in progress; false where there was none.
    bool cancel();
    /// Settings that show in the picture have changed.
    void refresh(bool moving = false);

    const OrbitView& view() const { return m_view; }
    render::Camera camera() const;
    const BrushCursor& cursor() const { return m_cursor; }

  signals:
    void radiusChanged();

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    enum class Gesture { None, Sculpt, Orbit, Pan };
    struct Pointer {
        QPointF place; ///< device pixels
        Qt::MouseButton button = Qt::NoButton;
        Qt::KeyboardModifiers modifiers;
        float pressure = 1;
    };
    bool mouse(QMouseEvent& event);
    bool tablet(QTabletEvent& event);
    bool wheel(QWheelEvent& event);
    bool key(QKeyEvent& event, bool pressed);
    void press(const Pointer& pointer);
    void move(const Pointer& pointer);
    void release(const Pointer& pointer);

    void beginStroke(const Pointer& pointer, const BrushContact& contact);
    void addSample(const Pointer& pointer);
    void dragRadius(double dx);
    std::optional<BrushContact> contactAt(const QPointF& place) const;
    double worldRadius(const base::Vec3d& contact) const;
    double pixelsAt(const base::Vec3d& p) const; ///< per model unit there
    void updateCursor();
    void followModel();
    void paintOverlay(QPainter& painter) const;

    Editor& m_editor;
    Settings& m_settings;
    Viewport& m_viewport;
    OrbitView m_view;
    std::uint64_t m_models = 0; ///< of the snapshot that the view was framed for
    Gesture m_gesture = Gesture::None;
    Qt::MouseButton m_button = Qt::NoButton; ///< that began the gesture and ends it
    Pointer m_pointer;                       ///< where it was last
    bool m_inside = false;
    std::optional<double> m_radiusBefore; ///< while F is held: what Esc goes back to
    QElapsedTimer m_strokeClock;
    BrushCursor m_cursor;
};

} // namespace ui
