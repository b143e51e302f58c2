#include "ui/number_slider.h"

#include <algorithm>
#include <cmath>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace ui {

/// 0 to 1 along the slider.
static double shareOf(const NumberRange& range, double value) {
    if (!(range.max > range.min))
        return 0;
    return range.logarithmic ? std::log(value / range.min) / std::log(range.max / range.min)
                             : (value - range.min) / (range.max - range.min);
}

static double valueOf(const NumberRange& range, double share) {
    return range.logarithmic ? range.min * std::pow(range.max / range.min, share)
                             : range.min + (range.max - range.min) * share;
}

NumberSlider::NumberSlider(const QString& label, const QString& tip, const NumberRange& range, QWidget* parent)
    : QWidget(parent), m_slider(new QSlider(Qt::Horizontal)), m_box(new QDoubleSpinBox) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(1);
    grid->addWidget(new QLabel(label), 0, 0);
    grid->addWidget(m_box, 0, 1);
    grid->addWidget(m_slider, 1, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    setToolTip(tip);
    m_box->setFixedWidth(104);
    m_box->setKeyboardTracking(false);
    m_box->setAlignment(Qt::AlignRight);
    m_box->setAccessibleName(label);
    m_slider->setRange(0, steps);
    m_slider->setPageStep(steps / 10);
    m_slider->setAccessibleName(label);
    setRange(range);
    connect(m_slider, &QSlider::valueChanged, this, &NumberSlider::slid);
    connect(m_box, &QDoubleSpinBox::valueChanged, this, &NumberSlider::typed);
}

void NumberSlider::setRange(const NumberRange& range) {
    m_range = range;
    const QSignalBlocker quiet(m_box);
    m_box->setDecimals(range.decimals);
    m_box->setRange(range.min, range.max);
    m_box->setSuffix(range.unit.isEmpty() ? QString() : " " + range.unit);
    if (range.logarithmic)
        m_box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    else
        m_box->setSingleStep((range.max - range.min) / 100);
    setValue(m_value);
}

void NumberSlider::setValue(double value) {
    m_value = std::clamp(value, m_range.min, m_range.max);
    showValue();
}

void NumberSlider::showValue() {
    const QSignalBlocker quietBox(m_box), quietSlider(m_slider);
    m_box->setValue(m_value);
    m_slider->setValue(static_cast<int>(std::lround(shareOf(m_range, m_value) * steps)));
}

void NumberSlider::slid(int step) {
    setValue(valueOf(m_range, static_cast<double>(step) / steps));
    emit edited(m_value);
}

void NumberSlider::typed(double value) {
    setValue(value);
    emit edited(m_value);
}

} // namespace ui
