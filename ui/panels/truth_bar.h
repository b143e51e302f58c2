// The bar of the true surface: how accurate its picture is to become, and its light. It edits a TruthSettings and
// emits it; it knows no view. Shown while the true surface is.
#pragma once

#include "ui/settings/settings.h"

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
    template <class Row, class Value>
    void choice(const char* name, const QString& tip, std::span<const Row> rows, Value Row::*member, Value& value);
    void check(const char* name, const QString& label, const QString& tip, bool& value);

    TruthSettings m_settings;
};

} // namespace ui
