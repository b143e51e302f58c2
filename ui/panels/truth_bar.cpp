#include "ui/panels/truth_bar.h"

#include "ui/panels/number_slider.h"

#include <QCheckBox>
#include <QComboBox>

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
    auto* quality = new NumberSlider(tr("Accuracy"),
                                     tr("1 px: normals within 2° and depths within a fifth of the spacing; 0.5 px: "
                                        "half of that. Coarser is faster."),
                                     range);
    quality->setObjectName("truth-quality");
    quality->setFixedWidth(220);
    quality->setValue(m_settings.quality);
    addWidget(quality);
    connect(quality, &NumberSlider::edited, this, [this](double value) {
        m_settings.quality = value;
        Q_EMIT edited(m_settings);
    });
    raycast::Lighting& lighting = m_settings.lighting;
    choice("truth-material", tr("Material of the surface"), raycast::materialTable(), &raycast::MaterialRow::material,
           lighting.material);
    choice("truth-lights", tr("Lights around the model"), raycast::lightRigTable(), &raycast::LightRigRow::rig,
           lighting.rig);
    check("truth-shadows", tr("Shadows"), tr("Shadows cast by the lights"), lighting.shadows);
    check("truth-occlusion", tr("Occlusion"), tr("Darkens where nearby surface blocks the ambient light"),
          lighting.occlusion);
    check("truth-ground", tr("Ground"), tr("A ground below the model receives both"), lighting.ground);
    setVisible(m_settings.on);
}

/// A list of a table's rows; `value` is a member of m_settings.
template <class Row, class Value>
void TruthBar::choice(const char* name, const QString& tip, std::span<const Row> rows, Value Row::*member,
                      Value& value) {
    auto* list = new QComboBox;
    list->setObjectName(name);
    list->setToolTip(tip);
    list->setFocusPolicy(Qt::NoFocus);
    for (const Row& row : rows) {
        list->addItem(tr(row.label));
        list->setItemData(list->count() - 1, tr(row.tip), Qt::ToolTipRole);
        if (row.*member == value)
            list->setCurrentIndex(list->count() - 1);
    }
    addWidget(list);
    connect(list, &QComboBox::currentIndexChanged, this, [this, rows, member, &value](int index) {
        value = rows[static_cast<std::size_t>(index)].*member;
        Q_EMIT edited(m_settings);
    });
}

void TruthBar::check(const char* name, const QString& label, const QString& tip, bool& value) {
    auto* box = new QCheckBox(label);
    box->setObjectName(name);
    box->setToolTip(tip);
    box->setFocusPolicy(Qt::NoFocus);
    box->setChecked(value);
    addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, &value](bool on) {
        value = on;
        Q_EMIT edited(m_settings);
    });
}

void TruthBar::setOn(bool on) {
    m_settings.on = on;
    setVisible(on);
    Q_EMIT edited(m_settings);
}

} // namespace ui
