#include "ui/panels/number_slider.h"

#include "ui/panels/value_bar.h"

#include <algorithm>
#include <cmath>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>

namespace ui {

/// 0 to 1 along the bar.
static double shareOf(const NumberRange& range, double value) {
    if (!(range.max > range.min))
        return 0;
    const double inside = std::clamp(value, range.min, range.max);
    return range.logarithmic ? std::log(inside / range.min) / std::log(range.max / range.min)
                             : (inside - range.min) / (range.max - range.min);
}

static double valueOf(const NumberRange& range, double share) {
    return range.logarithmic ? range.min * std::pow(range.max / range.min, share)
                             : range.min + (range.max - range.min) * share;
}

static double lowest(const NumberRange& range) {
    return std::isnan(range.typedMin) ? range.min : range.typedMin;
}
static double highest(const NumberRange& range) {
    return std::isnan(range.typedMax) ? range.max : range.typedMax;
}

NumberSlider::NumberSlider(const QString& label, const QString& tip, const NumberRange& range, QWidget* parent)
    : QWidget(parent), m_bar(new ValueBar(label)), m_box(new QDoubleSpinBox) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_bar);
    row->addWidget(m_box);
    setToolTip(tip);
    m_box->hide();
    m_box->setFixedHeight(ValueBar::height);
    m_box->setKeyboardTracking(false);
    m_box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_box->setAccessibleName(label);
    m_box->installEventFilter(this);
    m_bar->setRange(0, steps);
    m_bar->setPageStep(steps / 10);
    m_bar->setSingleStep(steps / 100);
    m_bar->setAccessibleName(label);
    setRange(range);
    connect(m_bar, &QSlider::valueChanged, this, &NumberSlider::slid);
    connect(m_bar, &ValueBar::clicked, this, &NumberSlider::beginTyping);
    connect(m_box, &QDoubleSpinBox::editingFinished, this, [this] { endTyping(true); });
}

void NumberSlider::setRange(const NumberRange& range) {
    m_range = range;
    const QSignalBlocker quiet(m_box);
    m_box->setDecimals(range.decimals);
    m_box->setRange(lowest(range), highest(range));
    m_box->setSuffix(range.unit.isEmpty() ? QString() : " " + range.unit);
    setValue(m_value);
}

void NumberSlider::setValue(double value) {
    m_value = std::clamp(value, lowest(m_range), highest(m_range));
    showValue();
}

void NumberSlider::showValue() {
    const QSignalBlocker quietBox(m_box), quietBar(m_bar);
    m_box->setValue(m_value);
    m_bar->setText(m_box->text());
    m_bar->setValue(static_cast<int>(std::lround(shareOf(m_range, m_value) * steps)));
}

void NumberSlider::slid(int step) {
    setValue(valueOf(m_range, static_cast<double>(step) / steps));
    Q_EMIT edited(m_value);
}

void NumberSlider::beginTyping() {
    m_bar->hide();
    m_box->show();
    m_box->setFocus();
    m_box->selectAll();
}

void NumberSlider::endTyping(bool take) {
    if (m_box->isHidden())
        return;
    const double typed = m_box->value();
    m_box->hide();
    m_bar->show();
    if (take && typed != m_value && std::abs(typed - m_value) > 0.5 * std::pow(10, -m_range.decimals)) {
        setValue(typed);
        Q_EMIT edited(m_value);
    } else
        showValue();
}

/// Escape forgets what is typed.
bool NumberSlider::eventFilter(QObject* object, QEvent* event) {
    const bool escape = (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) &&
                        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
    if (object == m_box && escape) {
        event->accept();
        if (event->type() == QEvent::KeyPress)
            endTyping(false);
        return true;
    }
    return QWidget::eventFilter(object, event);
}

} // namespace ui
