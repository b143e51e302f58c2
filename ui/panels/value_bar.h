// A slider and a field in one: name on the left, value on the right, filled as far as the value goes. Drag to change
// it (with Shift, in fine steps), click to type.
#pragma once

#include <QSlider>

namespace ui {

class ValueBar : public QSlider {
    Q_OBJECT
  public:
    static constexpr int height = 22;

    explicit ValueBar(const QString& label, QWidget* parent = nullptr);
    void setText(const QString& value);
    QSize sizeHint() const override { return {120, height}; }
    QSize minimumSizeHint() const override { return {40, height}; }

  Q_SIGNALS:
    void clicked(); ///< pressed and released without a drag, or Return

  protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void wheelEvent(QWheelEvent*) override; ///< goes on to what scrolls

  private:
    QString m_label, m_text;
    double m_at = 0; ///< the value while dragging, in steps, finer than the slider's
    int m_from = 0;  ///< x of the last event
    bool m_dragged = false;
};

} // namespace ui
