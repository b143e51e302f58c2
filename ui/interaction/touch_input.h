// Feeling the model with a device, and sculpting by touch: keeps the device's threads (haptics/live.h), tells them of
// the model and the view, and hands what the tool does to the editor as strokes like any other. Never waits.
//
// A mouse is a device, too: its place over the picture, pressed in by the left button (as far as a pen is pressed) and
// by the wheel; meanwhile neither does what it usually does. The simulated hand strokes what is in the middle of the
// picture, again and again. Interface's thread only.
#pragma once

#include "core/haptics/live.h"
#include "ui/interaction/brush_sizing.h"
#include "ui/interaction/clone_source.h"
#include "ui/interaction/pointer_router.h"
#include "ui/overlay/touch_overlay.h"
#include "ui/settings/touch_settings.h"

#include <QTimer>

namespace ui {

class TouchInput : public QObject {
    Q_OBJECT
  public:
    /// What it works with; all of it outlives it.
    struct Parts {
        Editor& editor;
        const Settings& settings;
        ViewMotion& motion;
        const BrushSizing& sizing;
        const CloneSource& source;
        const PointerRouter& pointer;
    };
    TouchInput(const Parts& parts, QWidget& canvas, QObject* parent = nullptr);
    ~TouchInput() override;

    /// Begins, goes on with, or ends. What cannot be opened is told, and it is off.
    void set(const TouchSettings& settings);
    const TouchSettings& settings() const { return m_set; }
    bool on() const { return m_live != nullptr; }
    /// Zero force at once, and off; false where it was.
    bool stop();
    /// The pointer begins a stroke of its own, which ends the tool's: it takes part again once it was let go.
    void letGo() { m_stroking = false; }
    const TouchLook& look() const { return m_look; }
    /// Of the device and the servo, in a few words.
    QString state() const;

  Q_SIGNALS:
    void felt();    ///< look() is new
    void stopped(); ///< by Esc, or since it cannot go on
    void hinted(QString what);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void open();
    void close();
    void poll();
    void sculpt(const haptics::Touched& touched);
    void endStroke();
    void turnView();
    void tellView();
    void point();
    haptics::ServoOptions servoOptions() const;
    haptics::ViewFrame frame() const;
    double scale() const; ///< model units per metre of the hand
    std::unique_ptr<haptics::Device> openDevice();

    Parts m_parts;
    QWidget& m_canvas;
    TouchSettings m_set;
    QTimer m_clock;
    std::unique_ptr<haptics::Live> m_live;
    std::unique_ptr<haptics::Device> m_viewDevice;
    haptics::ServoOptions m_options; ///< that the servo has
    TouchLook m_look;
    bool m_stroking = false;
    std::uint64_t m_stroke = 0; ///< of the tool: the last that was begun or let pass
    // Of the mouse.
    std::shared_ptr<haptics::Mailbox<haptics::DeviceState>> m_pointer;
    QPointF m_pixel;
    double m_depth = 0, m_pressed = 0; ///< behind the plane in front of the model, metres of the hand
    base::Vec3d m_plane;               ///< a place of that plane
};

} // namespace ui
