// What the pointer and the keys do in a viewport, whichever renderer draws it: one event filter, so that input logic
// exists once.
//
//     left on the model      a stroke of the chosen tool; Shift: the smoothing tool, Ctrl: inverted; Esc: as if not
//                            been
//     left beside it, right  turn the view, by the chosen style (left with Alt: anywhere); about the pivot
//     double click of those  picks the pivot: the place of the surface there, beside it the middle of the view
//     middle                 pan
//     wheel                  nearer and farther, towards what lies under the pointer
//     while flying           keys and pointer move the eye (navigator.h), the wheel sets the speed, Esc or a click land
//     F, Shift+F and moving  radius, strength; [ and ]: radius in steps
//     Ctrl+left              with a tool that copies: where from
//
// Interface's thread only. Pixels here are device pixels.
#pragma once

#include "core/render/named_views.h"
#include "core/render/overlay/section_lines.h"
#include "ui/viewport/brush_cursor.h"
#include "ui/viewport/cuts.h"
#include "ui/viewport/navigator.h"
#include "ui/viewport/viewport.h"
#include "ui/window/saved_views.h"
#include "ui/window/settings.h"
#include "ui/work/editor.h"
#include "ui/work/section_tracer.h"

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

    ~ViewController() override;

    Navigator& navigator() { return m_navigator; }
    void frameAll();
    /// What is not masked, where something is; else what is under the brush; else all.
    void frameSelection();
    void turnTo(const render::NamedView& view);
    void toggleParallel();
    /// The place of the surface under the pointer, by exact contact; where there is none, the middle of the view.
    void pickPivot();
    void fly();
    SavedView savedView(const std::string& name) const;
    void recall(const SavedView& view);

    const Cuts& cuts() const { return m_cuts; }
    void setCuts(const Cuts& cuts);
    /// Turns the free plane across the direction of view, through the middle of the model.
    void faceFreeCut();
    /// Of the planes as they are now; empty until they are traced.
    const render::SectionCurves& sections() const { return m_sections; }

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

    /// Where the view is or is smoothly going to be, and its camera: what picking and strokes use.
    const View& view() const { return m_navigator.view(); }
    render::Camera camera() const { return cameraOf(m_navigator.view()); }
    /// What the picture shows on the way there.
    render::Camera shownCamera() const { return cameraOf(m_navigator.shown()); }
    /// Painted over the picture and under the overlay, in device pixels of the camera that the picture shows.
    std::function<void(QPainter&, const render::Camera&)> beneath;
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
    void cutsChanged();                ///< here: another model, or the free plane turned
    void viewChanged();                ///< projection or flight, for what shows them

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
    render::Camera cameraOf(const View& view) const;
    std::optional<TrueSurface> truth() const; ///< where the settings ask for it
    void viewMoved(bool more);
    void turn(const Pointer& pointer);
    void lookAround(const Pointer& pointer);
    void pickPivotAt(const QPointF& place);
    void resetCuts();
    void traceSections();

    Editor& m_editor;
    Settings& m_settings;
    Viewport& m_viewport;
    std::shared_ptr<const render::BlockColours> m_colours;
    std::optional<render::ColourScale> m_scale;
    render::GroundGrid m_grid; ///< below the model as it was when it came
    Navigator m_navigator;
    Cuts m_cuts;
    render::SectionCurves m_sections;
    const void* m_tracedRoot = nullptr; ///< of the version last asked to be traced
    render::ClipPlanes m_tracedPlanes;
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
    bool m_mayWarp = true;                   ///< the window system moves the pointer where it is told
    bool m_warped = false;                   ///< the last move was ours
    std::unique_ptr<SectionTracer> m_tracer; ///< last: its thread ends first
};

} // namespace ui
