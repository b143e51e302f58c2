#include "ui/panels/touch_bar.h"

#include "core/haptics/device.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/number_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {

/// Three beside the plot fit over the picture of a window 1000 wide.
constexpr int sliderWidth = 142;

TouchBar::TouchBar(QWidget* parent) : QToolBar(tr("Touch"), parent) {
    setObjectName("touch");
    setMovable(false);
    auto* panel = new QWidget; // four rows: as wide as the other bars
    auto* grid = new QGridLayout(panel);
    grid->setContentsMargins(4, 2, 4, 2);
    grid->setSpacing(6);
    addWidget(panel);

    auto* devices = new QComboBox;
    devices->setObjectName("touch-device");
    devices->setToolTip(tr("What the hand holds; a device that is not there yet is waited for"));
    devices->setFocusPolicy(Qt::NoFocus);
    for (const haptics::DeviceRow& row : haptics::deviceTable()) {
        if (row.id == std::string_view("played")) // it has no hand
            continue;
        devices->addItem(tr(row.label), row.id);
        devices->setItemData(devices->count() - 1, tr(row.tip), Qt::ToolTipRole);
        if (row.id == m_settings.device)
            devices->setCurrentIndex(devices->count() - 1);
    }
    connect(devices, &QComboBox::currentIndexChanged, this, [this, devices] {
        m_settings.device = devices->currentData().toString().toStdString();
        Q_EMIT edited(m_settings);
    });
    m_on = check("touch-on", tr("Feel"), tr("The device moves a ball over the model and gets its force; Esc ends it"),
                 m_settings.on);
    QCheckBox* sculpts = check("touch-sculpts", tr("Sculpt"),
                               tr("Pressing makes the chosen tool work, the harder the stronger; tools that grab hold "
                                  "what is pressed until the hand rests"),
                               m_settings.sculpts);
    QCheckBox* view = check("touch-view", tr("3D mouse: view"),
                            tr("A second device, at spacenavd, moves the view meanwhile"), m_settings.viewDevice);
    auto* switches = new QHBoxLayout;
    switches->addWidget(m_on);
    switches->addWidget(sculpts);
    grid->addWidget(devices, 0, 0);
    grid->addLayout(switches, 0, 1);
    grid->addWidget(view, 0, 2);
    m_plot = new ForcePlot;
    grid->addWidget(m_plot, 0, 3, 4, 1);
    m_state = new QLabel;
    m_state->setObjectName("touch-state");
    grid->addWidget(m_state, 3, 1, 1, 2);

    NumberRange range;
    range.min = 50, range.max = 3000, range.logarithmic = true, range.decimals = 0, range.unit = "N/m";
    slider("touch-stiffness", tr("Stiffness"), tr("Of the clay; a device's own limit goes before"), range,
           m_settings.stiffness);
    range = {};
    slider("touch-friction", tr("Friction"),
           tr("The ball sticks below this part of the normal force, and slides above"), range, m_settings.friction);
    range = {};
    range.max = 20, range.decimals = 1, range.unit = "N s/m";
    slider("touch-viscosity", tr("Viscosity"), tr("How clay resists while the tool works on it"), range,
           m_settings.viscosity);
    range = {};
    slider("touch-tip", tr("Ball"), tr("Its radius, in radii of the brush"), range, m_settings.tip);
    range = {};
    slider("touch-relief", tr("Relief"), tr("Texture: how much harder ridges push than hollows"), range,
           m_settings.relief);
    slider("touch-grain", tr("Grain"), tr("Texture: how much harder light places push than dark ones"), range,
           m_settings.grain);
    range.min = 2, range.max = 60, range.decimals = 0, range.unit = "cm";
    slider("touch-reach", tr("Reach"), tr("How far the hand goes from the picture's lower edge to its upper"), range,
           m_settings.reach);
    int at = 0;
    for (const char* name : {"touch-stiffness", "touch-friction", "touch-viscosity", "touch-tip", "touch-reach",
                             "touch-relief", "touch-grain"}) {
        grid->addWidget(findChild<QWidget*>(name), 1 + at / 3, at % 3);
        ++at;
    }
}

void TouchBar::slider(const char* name, const QString& label, const QString& tip, const NumberRange& range,
                      double& value) {
    auto* out = new NumberSlider(label, tip, range, this);
    out->setObjectName(name);
    out->setFixedWidth(sliderWidth);
    out->setValue(value);
    connect(out, &NumberSlider::edited, this, [this, &value](double now) {
        value = now;
        Q_EMIT edited(m_settings);
    });
}

QCheckBox* TouchBar::check(const char* name, const QString& label, const QString& tip, bool& value) {
    auto* box = new QCheckBox(label);
    box->setObjectName(name);
    box->setToolTip(tip);
    box->setFocusPolicy(Qt::NoFocus);
    box->setChecked(value);
    connect(box, &QCheckBox::toggled, this, [this, &value](bool on) {
        value = on;
        Q_EMIT edited(m_settings);
    });
    return box;
}

void TouchBar::turnOff() {
    m_on->setChecked(false);
}

void TouchBar::showForce(double newtons, bool worked) {
    m_plot->add(newtons, worked);
}

void TouchBar::showState(const QString& words) {
    m_state->setText(words);
}

} // namespace ui
