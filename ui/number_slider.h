// A number with a name: a slider for the hand, a box for the exact value, both showing the same.
#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ui {

/// What a NumberSlider shows and allows.
struct NumberRange {
    double min = 0, max = 1;
    bool logarithmic = false; ///< REQUIRES: min > 0
    int decimals = 2;
    QString unit; ///< behind the number; may be empty
};

class NumberSlider : public QWidget {
    Q_OBJECT
  public:
    NumberSlider(const QString& label, const QString& tip, const NumberRange& range, QWidget* parent = nullptr);

    double value() const { return m_value; }
    /// Clamped to the range; does not emit.
    void setValue(double value);
    /// The value stays where the new range allows it; does not emit.
    void setRange(const NumberRange& range);

  signals:
    void edited(double value); ///< by the person

  private:
    void slid(int step);
    void typed(double value);
    void showValue();

    static constexpr int steps = 1000;
    NumberRange m_range;
    double m_value = 0;
    QSlider* m_slider;
    QDoubleSpinBox* m_box;
};

} // namespace ui
