#include "ui/truth_bar.h"

#include "ui/number_slider.h"

namespace ui {

TruthBar::TruthBar(const TruthSettings& settings, QWidget* parent)
    : QToolBar(tr("True Surface"), parent), m_settings(settings) {
    setObjectName("true-surface");
    setMovable(false);
    toggleViewAction()->setVisible(false); // the menu's switch decides
    NumberRange range;
    range.min = TruthSettings::minQuality, range.max = TruthSettings::maxQuality;
    range.logarithmic = true;
    range.unit = "px";
    auto* quality = new NumberSlider(
        tr("Accuracy"),
        tr("At 1 px normals within 2° and depths within a fifth of the spacing, at 0.5 px half of that; coarser is "
           "ready sooner"),
        range);
    quality->setObjectName("truth-quality");
    quality->setFixedWidth(220);
    quality->setValue(m_settings.quality);
    addWidget(quality);
    connect(quality, &NumberSlider::edited, this, [this](double value) {
        m_settings.quality = value;
        Q_EMIT edited(m_settings);
    });
    setVisible(m_settings.on);
}

void TruthBar::setOn(bool on) {
    m_settings.on = on;
    setVisible(on);
    Q_EMIT edited(m_settings);
}

} // namespace ui
