// The bar of feeling the model: the device, how the clay is, whether the tool works on it, the force over time and how
// punctual the servo is. It edits a TouchSettings and emits it; it knows no view and no device.
#pragma once

#include "ui/settings/touch_settings.h"

#include <QToolBar>

class QCheckBox;
class QLabel;

namespace ui {

class ForcePlot;
struct NumberRange;

class TouchBar : public QToolBar {
    Q_OBJECT
  public:
    explicit TouchBar(QWidget* parent = nullptr);

    const TouchSettings& settings() const { return m_settings; }
    /// Off, as Esc does.
    void turnOff();
    void showForce(double newtons, bool worked);
    /// Of the device and the servo, in a few words.
    void showState(const QString& words);

  Q_SIGNALS:
    void edited(const TouchSettings& settings);

  private:
    void slider(const char* name, const QString& label, const QString& tip, const NumberRange& range, double& value);
    QCheckBox* check(const char* name, const QString& label, const QString& tip, bool& value);

    TouchSettings m_settings;
    QCheckBox* m_on = nullptr;
    ForcePlot* m_plot = nullptr;
    QLabel* m_state = nullptr;
};

} // namespace ui
