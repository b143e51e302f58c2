// A curve through points, drawn and changed by hand: drag a point, click beside the curve's points to add one,
// right-click (or drag out of the field) to remove one. What a BrushCurve refuses cannot be drawn.
//
// It may show some other curve in place of its own, faintly; the first touch then copies that one to start from.
#pragma once

#include "core/sculpt/brush_curve.h"

#include <functional>
#include <QWidget>

class QPainterPath;

namespace ui {

class CurveEditor : public QWidget {
    Q_OBJECT
  public:
    using Shape = std::function<float(float)>;

    explicit CurveEditor(QWidget* parent = nullptr);

    const sculpt::CurvePoints& points() const { return m_points; }
    /// Does not emit. REQUIRES: what a BrushCurve takes.
    void setPoints(const sculpt::CurvePoints& points);
    /// Shown in place of the curve until somebody changes it; null: the curve itself.
    void setShape(Shape shape);
    /// Where a point of the curve's plane is in the widget.
    QPointF placeOf(sculpt::CurvePoint point) const;

    QSize sizeHint() const override { return {160, 84}; }
    QSize minimumSizeHint() const override { return {80, 60}; }

  Q_SIGNALS:
    void edited(); ///< by the person; points() is new

  protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void leaveEvent(QEvent*) override;

  private:
    QRectF field() const;
    sculpt::CurvePoint pointAt(const QPointF& place) const;
    int nearest(const QPointF& place) const; ///< -1: none within reach
    int insert(sculpt::CurvePoint point);    ///< its index; -1: no room
    void adopt();
    void changed();
    QPainterPath lineOf(const Shape& value) const;
    void paintPoints(QPainter& painter, const sculpt::CurvePoints& points) const;

    sculpt::CurvePoints m_points{{0, 1}, {1, 0}};
    Shape m_shape;
    int m_held = -1, m_under = -1;
    bool m_out = false; ///< dragged out of the field: let go, and it is gone
};

} // namespace ui
