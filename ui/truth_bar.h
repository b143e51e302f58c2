// The bar of the true surface: how accurate its picture is to become. It edits a TruthSettings and says so; it knows
// no view. Shown while the true surface is.
#pragma once

#include "ui/settings.h"

#include <QToolBar>

namespace ui {

class NumberSlider;

class TruthBar : public QToolBar {
    Q_OBJECT
  public:
    explicit TruthBar(const TruthSettings& settings, QWidget* parent = nullptr);

    const TruthSettings& settings() const { return m_settings; }
    void setOn(bool on);

  Q_SIGNALS:
    void edited(const TruthSettings& settings);

  private:
    TruthSettings m_settings;
};

} // namespace ui
