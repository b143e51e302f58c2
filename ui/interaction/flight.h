// Flying through the model with keys and pointer: what the hand does while the eye moves (Fly has the motion). Near
// the border the pointer is put back into the middle, where the window system allows it. Interface's thread only.
#pragma once

#include "ui/interaction/navigator.h"
#include "ui/work/editor.h"

class QKeyEvent;
class QWidget;

namespace ui {

class Flight : public QObject {
    Q_OBJECT
  public:
    /// All outlive it.
    Flight(Navigator& navigator, const Editor& editor, QWidget& canvas, QObject* parent = nullptr);

    bool on() const { return m_navigator.flying(); }
    /// From here, at a speed that suits the model's size.
    void takeOff();
    void land();
    /// Is a key an order to the flight rather than a shortcut?
    bool takes(int key) const { return on() && Navigator::isFlyKey(key); }
    /// REQUIRES: takes(event.key()).
    void key(const QKeyEvent& event, bool pressed);
    /// The pointer has moved, in device pixels: the eye turns. Returns where the pointer is then.
    QPointF look(const QPointF& fromPx, const QPointF& toPx);
    /// Steps of a wheel: faster.
    void accelerate(double steps);

  Q_SIGNALS:
    void hinted(QString what); ///< for the person who flies

  private:
    Navigator& m_navigator;
    const Editor& m_editor;
    QWidget& m_canvas;
    bool m_mayWarp = true; ///< the window system moves the pointer where it is told
    bool m_warped = false; ///< the last move was ours
};

} // namespace ui
