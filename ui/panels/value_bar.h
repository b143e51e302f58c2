// A slider that is a field at once: name left, value right, the filled part tells how far along. Drag to change (with
// Shift: finely), click to type.
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
