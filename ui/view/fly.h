// Flying: the eye moves with keys and looks with the pointer. Plain value; Navigator feeds it time and keys.
//
// The velocity u approaches what the keys ask for, w, as du/dt = (w - u) / tau, solved in closed form over each step,
//
//     u(t) = w + (u0 - w) e^(-t/tau),   x(t) = x0 + w t + (u0 - w) tau (1 - e^(-t/tau))
//
// so the result does not depend on how time is cut into frames (ui/README 5).
#pragma once

#include "ui/view/view.h"

namespace ui {

class Fly {
  public:
    static constexpr double tau = 0.08; ///< seconds
    enum Key : unsigned { Forward = 1, Back = 2, Left = 4, Right = 8, Up = 16, Down = 32, Fast = 64 };

    /// From a view (in perspective from then on), at `speed` model units per second.
    Fly(const View& view, double speed);

    const View& view() const { return m_view; }
    double speed() const { return m_speed; }
    /// By steps of a wheel: each makes it a quarter faster.
    void accelerate(double steps);
    void press(Key key) { m_keys |= key; }
    void release(Key key) { m_keys &= ~unsigned(key); }
    /// The pointer has moved: the view turns with it.
    void look(double dx, double dy, int height);
    void step(double seconds);
    /// Still going somewhere?
    bool moving() const;

  private:
    base::Vec3d wanted() const; ///< velocity in the model's axes

    View m_view;
    double m_speed;
    unsigned m_keys = 0;
    base::Vec3d m_velocity;
};

} // namespace ui
