// Up to eight actions around the place where the pointer is: the direction chooses, the way need not be looked at. A
// click takes what lies in its direction, or nothing in the middle; so does letting go of the key that opened it once
// the pointer has moved. It lies over the picture until then; Esc takes nothing. Interface's thread only.
#pragma once

#include <QAction>
#include <QWidget>

namespace ui {

class PieMenu : public QWidget {
    Q_OBJECT
  public:
    static constexpr qsizetype most = 8;

    /// At a place of the canvas, with as many of the actions as there is room for. Deletes itself.
    PieMenu(QWidget& canvas, const QPoint& at, const QList<QAction*>& actions);
    /// From the middle, in pixels.
    QPointF direction(qsizetype which) const;
    QPoint middle() const { return m_middle; }

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    qsizetype actionAt(const QPointF& at) const; ///< -1: none
    QRectF plateOf(qsizetype which) const;
    void take(qsizetype which);

    QPoint m_middle;
    QList<QAction*> m_actions;
    qsizetype m_under = -1;
    bool m_done = false;
};

} // namespace ui
