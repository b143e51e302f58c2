// What the pointer and the keys do in a viewport, whichever renderer draws it: one event filter, so that input logic
// exists once.
//
//     left on the model      a stroke of the chosen tool; Shift: the smoothing tool, Ctrl: inverted; Esc: as if not
//                            been
//     left beside it, right  orbit (left with Alt: anywhere)
//     middle                 pan
//     wheel                  nearer and farther, towards what lies under the pointer
//     F, Shift+F and moving  radius, strength; [ and ]: radius in steps
//     Ctrl+left              with a tool that copies: where from
//
// Interface's thread only. Pixels here are device pixels.
#pragma once

#include "ui/brush_cursor.h"
#include "ui/editor.h"
#include "ui/orbit_view.h"
#include "ui/render/named_views.h"
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
    enum class Gesture { None, Sculpt, Orbit, Pan };

    /// All three outlive the controller.
    ViewController(Editor& editor, Settings& settings, Viewport& viewport, QObject* parent = nullptr);

    void frameAll();
    void turnTo(const render::NamedView& view);
    /// Radius times `factor`, in whichever unit is chosen.
    void scaleRadius(double factor);
    /// Strength of the chosen tool, `by` more.
    void shiftStrength(double by);
    /// Esc: drops the stroke or the change of radius in progress; false where there was none.
    bool cancel();
    /// Settings that show in the picture have changed.
    void refresh(bool moving = false);
    /// What a shading that measures shows from now on, and what its colours mean; null: nothing.
    void showColours(std::shared_ptr<const render::BlockColours> colours,
                     const std::optional<render::ColourScale>& scale);
    /// All that the settings and the model say of the picture's look; without colours.
    render::RenderOptions look() const;

    const OrbitView& view() const { return m_view; }
    render::Camera camera() const;
    const BrushCursor& cursor() const { return m_cursor; }
    /// Presses, moves and releases so far: the number of the last.
    std::uint64_t inputs() const { return m_inputs; }
    Gesture gesture() const { return m_gesture; }
    /// Where tools that copy copy from, in stored coordinates; nothing before it is chosen.
    const std::optional<base::Vec3d>& source() const { return m_source; }

  Q_SIGNALS:
    void brushChanged();               ///< radius or strength, here
    void sourceChanged(QString place); ///< in the file's coordinates; empty: none
    void hinted(QString what);         ///< what the person has to do first

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
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
    void chooseSource(const std::optional<base::Vec3d>& place);
    void dragValue(double dx);
    double& draggedRadius(); ///< in whichever unit is chosen
    void endDrag(bool keep);
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
    std::shared_ptr<const render::BlockColours> m_colours;
    std::optional<render::ColourScale> m_scale;
    render::GroundGrid m_grid;  ///< below the model as it was when it came
    std::uint64_t m_models = 0; ///< of the snapshot that the view was framed for
    Gesture m_gesture = Gesture::None;
    Qt::MouseButton m_button = Qt::NoButton; ///< that began the gesture and ends it
    Pointer m_pointer;                       ///< where it was last
    bool m_inside = false;
    enum class Dragged { Radius, Strength };
    struct ValueDrag {
        Dragged what;
        double before; ///< what Esc goes back to
    };
    std::optional<ValueDrag> m_drag;     ///< while F is held
    std::optional<base::Vec3d> m_source; ///< of tools that copy
    base::Vec3d m_strokeStart;           ///< contact where the stroke in progress began
    QElapsedTimer m_strokeClock;
    std::uint64_t m_inputs = 0, m_viewInput = 0; ///< all; the last that moved the view
    BrushCursor m_cursor;
};

} // namespace ui
