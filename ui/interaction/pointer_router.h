// What the pointer and the keys do in a viewport, whichever renderer draws it: one event filter, so that input logic
// exists once (ui/README 4). It tells gestures apart and hands them on; what they do is done elsewhere.
//
//     left on the model      a stroke of the chosen tool; Shift: the smoothing tool, Ctrl: inverted; Esc: as if it
//                            had not been                                                        StrokeInput
//     left on another model  makes it the active one
//     left beside it, right  turn the view in the chosen style (left with Alt: anywhere)          ViewMotion
//     double click of those  picks the pivot: the place of the surface there, or without one the middle of the view
//     middle                 pan
//     wheel                  nearer and farther, towards what lies under the pointer
//     while flying           keys and pointer move the eye, the wheel sets the speed, Esc or a click lands   Flight
//     F, Shift+F and moving  radius, strength, until the key comes up; after a tap of the key until a click (right
//     button
//                            or Esc: as it was); the brush stays where it is meanwhile             BrushSizing
//     Ctrl+left              with a tool that copies: where from                                  CloneSource
//
// Interface's thread only. Pixels here are device pixels.
#pragma once

#include "ui/interaction/cursor_tracker.h"
#include "ui/interaction/flight.h"
#include "ui/interaction/stroke_input.h"

class QMouseEvent;
class QTabletEvent;
class QWheelEvent;
class QKeyEvent;

namespace ui {

class PointerRouter : public QObject {
    Q_OBJECT
  public:
    enum class Gesture { None, Sculpt, Orbit, Pan };

    /// What gestures are handed to; all of it outlives the router.
    struct Parts {
        const Editor& editor;
        const Settings& settings;
        ViewMotion& motion;
        Flight& flight;
        BrushSizing& sizing;
        CloneSource& source;
        StrokeInput& strokes;
        CursorTracker& cursor;
    };
    /// Filters the events of `canvas`, which outlives it.
    PointerRouter(const Parts& parts, QWidget& canvas, QObject* parent = nullptr);

    Gesture gesture() const { return m_gesture; }
    /// Presses, moves and releases so far: the number of the last.
    std::uint64_t inputs() const { return m_inputs; }
    /// Of the pointer where it is, over the viewport; else nothing.
    std::optional<BrushContact> contactUnderPointer() const;
    /// Esc: drops the stroke or the change of radius in progress, ends a flight; false where there was none.
    bool cancel();
    /// The view turns about the place of the surface under the pointer; without one, about the middle of the view.
    void pickPivot();
    /// Begins a flight, unless a gesture is under way.
    void takeOff();
    /// The brush's cursor is to be where the pointer is: the picture may be another one.
    void followCursor();

  Q_SIGNALS:
    void pictureChanged(bool moving); ///< by the wheel, the end of a gesture, another size
    void touched(QString tool);       ///< a stroke of it begins
    void modelPicked(QString name);   ///< a press on a model that is not the active one
    void hinted(QString what);        ///< what the person has to do first, or has just done

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    bool mouse(const QMouseEvent& event);
    bool tablet(QTabletEvent& event);
    bool wheel(QWheelEvent& event);
    bool key(const QKeyEvent& event, bool pressed);
    void holdF(const QKeyEvent& event, bool pressed);
    void leave(bool unfocused);

    void press(const Pointer& pointer);
    void move(const Pointer& pointer);
    void release(const Pointer& pointer);
    /// A press of the left button on the model.
    void touch(const Pointer& pointer, const BrushContact& contact);
    void pickPivotAt(const std::optional<BrushContact>& contact);
    std::optional<BrushContact> contactAt(const QPointF& pixel) const;

    Parts m_parts;
    QWidget& m_canvas;
    Gesture m_gesture = Gesture::None;
    Qt::MouseButton m_button = Qt::NoButton; ///< that began the gesture and ends it
    Pointer m_pointer;                       ///< where it was last
    Pointer m_sized;                         ///< where it was when F went down: there the brush stays
    bool m_sizedByMove = false;              ///< moved since then: the key's release ends it
    bool m_inside = false;                   ///< over the viewport
    std::uint64_t m_inputs = 0;
};

} // namespace ui
