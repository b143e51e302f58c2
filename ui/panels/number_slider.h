// A named number: a bar to drag, replaced by a box while an exact value is typed.
#pragma once

#include <limits>
#include <QWidget>

class QDoubleSpinBox;

namespace ui {

class ValueBar;

/// What a NumberSlider shows and allows.
struct NumberRange {
    double min = 0, max = 1;
    bool logarithmic = false; ///< REQUIRES: min > 0
    int decimals = 2;
    QString unit; ///< behind the number; may be empty
    /// What may be typed; the bar spans min to max. NaN: the same.
    double typedMin = std::numeric_limits<double>::quiet_NaN(), typedMax = typedMin;
};

class NumberSlider : public QWidget {
    Q_OBJECT
  public:
    NumberSlider(const QString& label, const QString& tip, const NumberRange& range, QWidget* parent = nullptr);

    double value() const { return m_value; }
    /// Clamped to what may be typed; does not emit.
    void setValue(double value);
    /// The value stays where the new range allows it; does not emit.
    void setRange(const NumberRange& range);

  Q_SIGNALS:
    void edited(double value); ///< by the person

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void slid(int step);
    void beginTyping();
    void endTyping(bool take);
    void showValue();

    static constexpr int steps = 1000;
    NumberRange m_range;
    double m_value = 0;
    ValueBar* m_bar;
    QDoubleSpinBox* m_box; ///< hidden unless one types
};

} // namespace ui
