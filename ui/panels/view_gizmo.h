// The axes of the model as they lie in the picture, in its upper right corner: a click on an end of one looks from
// there, a second one from the opposite side; a drag turns the view. It knows no view: its owner tells where the axes
// point. Interface's thread only.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <optional>
#include <QWidget>

namespace ui {

class ViewGizmo : public QWidget {
    Q_OBJECT
  public:
    static constexpr int side = 92; ///< of it, in pixels

    explicit ViewGizmo(QWidget& canvas);
    /// Of the picture, as directions of the model: to the right, upwards, to the eye.
    void setAxes(const base::Vec3d& right, const base::Vec3d& up, const base::Vec3d& toEye);
    /// Whether it is wanted; a small canvas has no room for it.
    void setWanted(bool wanted);
    /// Where an end of an axis is: axis 0 to 2.
    QPointF place(int axis, bool positive) const;

  Q_SIGNALS:
    void sideWanted(base::Vec3d toEye);
    void dragged(QPointF by); ///< in pixels

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    struct End {
        int axis = 0;
        bool positive = true;
        double depth = 0; ///< towards the eye
        bool operator==(const End& o) const { return axis == o.axis && positive == o.positive; }
    };
    std::array<End, 6> ends() const; ///< the farthest first
    std::optional<End> endAt(const QPointF& at) const;
    base::Vec3d seen(int axis, bool positive) const; ///< right, up, to the eye
    void fit();

    QWidget& m_canvas;
    base::Vec3d m_right{1, 0, 0}, m_up{0, 1, 0}, m_toEye{0, 0, 1};
    bool m_wanted = true, m_dragging = false;
    QPointF m_pressed;
    std::optional<End> m_under; ///< the pointer
};

} // namespace ui
