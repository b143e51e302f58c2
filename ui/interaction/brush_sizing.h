// Radius and strength of the brush: changed in steps, or by moving the pointer after F or Shift+F. Writes to the
// settings. Interface's thread only.
#pragma once

#include "ui/interaction/view_motion.h"
#include "ui/settings/settings.h"

class QKeyEvent;

namespace ui {

class BrushSizing : public QObject {
    Q_OBJECT
  public:
    enum class Value { Radius, Strength };

    /// All outlive it.
    BrushSizing(Settings& settings, const ViewMotion& motion, const QWidget& canvas, QObject* parent = nullptr);

    /// Radius times `factor`, in whichever unit is chosen.
    void scaleRadius(double factor);
    /// The same radius in the other unit, as it is in the middle of the view.
    void chooseUnit(RadiusUnit unit);
    /// Strength of the chosen tool, `by` more.
    void shiftStrength(double by);

    /// From now on `drag` changes this value.
    void beginDrag(Value value);
    bool dragging() const { return m_drag.has_value(); }
    /// A key that a number is typed with, or ended: digits, a point, Backspace, Enter.
    static bool types(const QKeyEvent& key);
    /// The value is what has been typed; true for Enter, which ends the drag. REQUIRES: dragging, types(key).
    bool type(const QKeyEvent& key);
    /// The pointer has moved to the right by this many device pixels; once something is typed that means nothing.
    /// REQUIRES: dragging.
    void drag(double dxPx);
    /// Ends the drag; without `keep` the value is what it was before. REQUIRES: dragging.
    void endDrag(bool keep);
    /// Where strength is dragged: how strong, 0 to 1.
    std::optional<double> draggedStrength() const;
    /// What the drag is changing, for display beside the pointer; empty without a drag.
    QString label() const;

    /// Model units, for a brush at this place.
    double radiusAt(const base::Vec3d& place) const;
    /// Device pixels, for a brush that touches nothing.
    double radiusPx() const;

  Q_SIGNALS:
    void changed(); ///< radius or strength, here

  private:
    struct Drag {
        Value value;
        double before; ///< what Esc goes back to
        QString typed;
    };
    void set(double value); ///< of what is dragged
    double& radius() const; ///< in whichever unit is chosen
    float strength() const;

    Settings& m_settings;
    const ViewMotion& m_motion;
    const QWidget& m_canvas;
    std::optional<Drag> m_drag;
};

} // namespace ui
