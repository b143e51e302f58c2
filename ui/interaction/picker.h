// Picks in the viewport in place of sculpting: an outline drawn over the picture, or a place of the surface. While it
// is on, the left button picks, whatever lies under it; everything else goes on to the PointerRouter, so that the view
// turns, pans and zooms as ever.
//
//     rectangle, lasso   pressed, drawn, let go
//     polygon            a click a corner; a double click, Enter or the first corner again closes it, Backspace takes
//                        the last corner back
//     place              a click on the surface
//
// What is picked goes to whoever began; another that begins ends the one before. Interface's thread only.
#pragma once

#include "ui/interaction/view_motion.h"
#include "ui/overlay/brush_cursor.h"

class QKeyEvent;
class QMouseEvent;
class QTabletEvent;

namespace ui {

enum class PickShape { Rectangle, Lasso, Polygon, Place };

struct Pick {
    std::vector<QPointF> corners;        ///< of an outline, device pixels; of a rectangle two that are opposite
    std::optional<BrushContact> contact; ///< of a place
    render::Camera camera;               ///< that it was seen with
    Qt::KeyboardModifiers modifiers;     ///< held when it began
};

class Picker : public QObject {
    Q_OBJECT
  public:
    /// `then` gets each pick until `ended` is called, by `end` or since another begins.
    struct Owner {
        PickShape shape = PickShape::Place;
        std::function<void(const Pick&)> then;
        std::function<void()> ended;
        bool once = false; ///< the first pick ends it
    };

    /// All outlive it. Its events are taken before those of filters that were installed earlier.
    Picker(const Editor& editor, const ViewMotion& motion, QWidget& canvas, QObject* parent = nullptr);

    void begin(Owner owner);
    void end();
    /// Drops the outline in progress; false where there was none.
    bool cancel();
    bool on() const { return m_on; }
    PickShape shape() const { return m_owner.shape; }
    /// In progress, with the pointer as the last corner; empty: nothing is.
    const std::vector<QPointF>& outline() const { return m_outline; }

  Q_SIGNALS:
    void hinted(QString what);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    bool mouse(const QMouseEvent& event);
    bool tablet(QTabletEvent& event);
    bool key(const QKeyEvent& event);
    bool press(const QPointF& pixel, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    bool move(const QPointF& pixel);
    bool release(const QPointF& pixel, Qt::MouseButton button);
    void pickPlace(const QPointF& pixel);
    void addCorner(const QPointF& pixel);
    void close();
    void deliver(const Pick& pick);

    const Editor& m_editor;
    const ViewMotion& m_motion;
    QWidget& m_canvas;
    Owner m_owner;
    bool m_on = false, m_held = false; ///< the left button, since it began an outline
    std::vector<QPointF> m_outline;
    Qt::KeyboardModifiers m_modifiers;
    render::Camera m_camera;
};

} // namespace ui
