// Moves the window's view: drags in the chosen style, smooth transitions to other views, flight. It knows neither
// viewport nor model; its owner shows `shown()` whenever it signals that it has moved.
//
// A transition takes `transitionSeconds` and holds nothing up: `view()` is its destination from the first moment on,
// and whatever moves the view next (or `finish`) ends it there.
//
// Interface's thread only.
#pragma once

#include "ui/view/fly.h"
#include "ui/view/navigation.h"
#include "ui/view/view.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui {

class Navigator : public QObject {
    Q_OBJECT
  public:
    static constexpr double transitionSeconds = 0.2;

    explicit Navigator(QObject* parent = nullptr);

    /// Where the view is or will be.
    const View& view() const { return m_view; }
    /// Where it is now, on its way there.
    View shown() const;
    bool inTransition() const { return m_transition.has_value(); }

    void set(const View& view);  ///< at once
    void goTo(const View& view); ///< smoothly
    void finish();               ///< a transition ends at its destination
    void setSmooth(bool smooth) { m_smooth = smooth; }
    void chooseStyle(const NavigationRow& style);

    void drag(const ImagePoint& from, const ImagePoint& to, int width, int height);
    void pan(double dx, double dy, int height);
    void zoom(double steps, const base::Vec3d& about);
    void setParallel(bool parallel);
    void setPivot(const std::optional<base::Vec3d>& pivot); ///< moves no pixel

    bool flying() const { return m_fly.has_value(); }
    /// From here, at `speed` model units per second.
    void takeOff(double speed);
    void land();
    static bool isFlyKey(int key);
    /// REQUIRES: flying, and a key that flies.
    void flyKey(int key, bool pressed);
    void look(double dx, double dy, int height);
    /// By steps of a wheel; returns the new speed.
    double accelerate(double steps);

  Q_SIGNALS:
    void moved(bool more); ///< `more`: it keeps moving
    void flightChanged(bool flying);

  private:
    struct Transition {
        View from;
        QElapsedTimer since;
    };
    double part() const;
    void tick();

    View m_view;
    const NavigationRow* m_style;
    std::optional<Transition> m_transition;
    std::optional<Fly> m_fly;
    QElapsedTimer m_lastStep;
    QTimer m_timer;
    bool m_smooth = true;
};

} // namespace ui
