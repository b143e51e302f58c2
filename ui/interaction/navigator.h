// Moves the window's view: drags by the chosen style, smooth ways to other views, flying. Knows no viewport and no
// model; whoever owns it shows `shown()` whenever it says that it has moved.
//
// A way to another view takes `transitionSeconds` and holds nothing up: `view()` is where it leads from the first
// moment on, and whatever moves the view next (or `finish`) ends it there.
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

    /// Where the view is or is going to be.
    const View& view() const { return m_view; }
    /// Where it is on its way there.
    View shown() const;
    bool underWay() const { return m_way.has_value(); }

    void set(const View& view);  ///< at once
    void goTo(const View& view); ///< smoothly
    void finish();               ///< the way ends where it leads
    void setSmooth(bool smooth) { m_smooth = smooth; }
    void chooseStyle(const NavigationRow& style);
    const NavigationRow& style() const { return *m_style; }

    void drag(const ImagePlace& from, const ImagePlace& to, int width, int height);
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
    /// Steps of a wheel; the speed then.
    double accelerate(double steps);

  Q_SIGNALS:
    void moved(bool more); ///< `more` will follow at once
    void flightChanged(bool flying);

  private:
    struct Way {
        View from;
        QElapsedTimer since;
    };
    double part() const;
    void tick();

    View m_view;
    const NavigationRow* m_style;
    std::optional<Way> m_way;
    std::optional<Fly> m_fly;
    QElapsedTimer m_lastStep;
    QTimer m_timer;
    bool m_smooth = true;
};

} // namespace ui
