#include "ui/properties_panel.h"

#include "ui/icon.h"
#include "ui/number_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace ui {

static QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    label->setObjectName("heading");
    label->setIndent(0);
    return label;
}

PropertiesPanel::PropertiesPanel(Settings& settings, QWidget* parent) : QScrollArea(parent), m_settings(settings) {
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(12, 4, 12, 12);
    layout->setSpacing(8);
    buildBrush(*layout);
    buildSymmetry(*layout);
    buildSwitches(*layout);
    m_toolHeading = heading({});
    layout->addWidget(m_toolHeading);
    m_toolParameters = new QVBoxLayout;
    m_toolParameters->setSpacing(8);
    layout->addLayout(m_toolParameters);
    layout->addStretch();
    setWidget(content);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedWidth(256);
    refresh();
}

void PropertiesPanel::buildBrush(QVBoxLayout& layout) {
    layout.addWidget(heading(tr("Brush")));
    m_radius =
        new NumberSlider(tr("Radius"), tr("Radius of the brush; [ and ], or hold F and move, change it too."), {});
    connect(m_radius, &NumberSlider::edited, this, [this](double value) {
        (m_settings.radiusUnit == RadiusUnit::Pixels ? m_settings.radiusPx : m_settings.radiusModel) = value;
        emit edited();
    });
    layout.addWidget(m_radius);

    m_unit = new QComboBox;
    m_unit->addItem(tr("Radius in pixels"));
    m_unit->addItem(tr("Radius in model units"));
    m_unit->setToolTip(tr("In pixels the brush keeps its size on the screen, in model units its size on the model."));
    connect(m_unit, &QComboBox::activated, this, [this](int index) {
        m_settings.radiusUnit = index == 0 ? RadiusUnit::Pixels : RadiusUnit::Model;
        showRadius();
        emit edited();
    });
    layout.addWidget(m_unit);

    m_strength =
        new NumberSlider(tr("Strength"), tr("How much one dab does; the pressure of a pen multiplies it."), {});
    connect(m_strength, &NumberSlider::edited, this, &PropertiesPanel::edit);
    layout.addWidget(m_strength);

    auto* row = new QHBoxLayout;
    m_falloff = new QComboBox;
    for (const auto& curve : sculpt::falloffTable())
        m_falloff->addItem(curve.label);
    m_falloff->setToolTip(tr("How a dab fades from its centre to its rim."));
    connect(m_falloff, &QComboBox::activated, this, [this](int index) {
        m_settings.falloff = sculpt::falloffTable()[static_cast<std::size_t>(index)].falloff;
        emit edited();
    });
    row->addWidget(new QLabel(tr("Falloff")));
    row->addWidget(m_falloff, 1);
    layout.addLayout(row);

    m_spacing = new NumberSlider(tr("Spacing"), tr("Distance of dabs along the stroke, as a part of the radius."),
                                 {Settings::minSpacing, Settings::maxSpacing, true, 2, {}});
    connect(m_spacing, &NumberSlider::edited, this, [this](double value) {
        m_settings.spacing = value;
        emit edited();
    });
    layout.addWidget(m_spacing);
}

void PropertiesPanel::buildSymmetry(QVBoxLayout& layout) {
    layout.addWidget(heading(tr("Symmetry")));
    auto* row = new QHBoxLayout;
    bool* const flags[] = {&m_settings.symmetry.x, &m_settings.symmetry.y, &m_settings.symmetry.z};
    const char* const names[] = {"X", "Y", "Z"};
    for (int k = 0; k < 3; ++k) {
        auto* button = m_axes[k] = new QToolButton;
        button->setObjectName("axis");
        button->setText(names[k]);
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setToolTip(tr("Every dab is made on both sides of the plane %1 = 0.").arg(QString(names[k]).toLower()));
        connect(button, &QToolButton::clicked, this, [this, flag = flags[k]](bool on) {
            *flag = on;
            emit edited();
        });
        row->addWidget(button, 1);
    }
    layout.addLayout(row);
}

void PropertiesPanel::buildSwitches(QVBoxLayout& layout) {
    const auto add = [&](const char* name, const QString& text, const QString& tip, bool& flag) {
        auto* box = new QCheckBox(text);
        box->setIcon(icon(name));
        box->setToolTip(tip);
        connect(box, &QCheckBox::clicked, this, [this, &flag](bool on) {
            flag = on;
            emit edited();
        });
        layout.addWidget(box);
        return box;
    };
    layout.addWidget(heading(tr("Stroke")));
    m_invert = add("invert", tr("Invert"), tr("The tool's opposite; Ctrl does it while held."), m_settings.invert);
    m_resample = add("resample", tr("Resample"), tr("The sampling follows the deformation: gaps fill, crowds merge."),
                     m_settings.resample);
}

void PropertiesPanel::edit(double strength) {
    const auto& row = m_settings.toolRow();
    ToolChoice choice = m_settings.choice(row);
    choice.strength = strength;
    m_settings.tools[row.id] = choice;
    emit edited();
}

void PropertiesPanel::editParameter(const std::string& id, double value) {
    const auto& row = m_settings.toolRow();
    ToolChoice choice = m_settings.choice(row);
    choice.parameters[id] = value;
    m_settings.tools[row.id] = choice;
    emit edited();
}

// --- showing ---

void PropertiesPanel::setModelSize(double diagonal) {
    if (diagonal > 0 && std::isfinite(diagonal))
        m_diagonal = diagonal;
    showRadius();
}

void PropertiesPanel::showRadius() {
    const bool pixels = m_settings.radiusUnit == RadiusUnit::Pixels;
    m_unit->setCurrentIndex(pixels ? 0 : 1);
    if (pixels)
        m_radius->setRange({Settings::minRadiusPx, Settings::maxRadiusPx, true, 0, tr("px")});
    else {
        const int digits = static_cast<int>(std::ceil(-std::log10(m_diagonal))) + 4;
        m_radius->setRange({m_diagonal * 1e-3, m_diagonal * 0.5, true, std::clamp(digits, 0, 9), {}});
        m_settings.radiusModel = std::clamp(m_settings.radiusModel, m_diagonal * 1e-3, m_diagonal * 0.5);
    }
    m_radius->setValue(pixels ? m_settings.radiusPx : m_settings.radiusModel);
}

void PropertiesPanel::showTool() {
    const auto& row = m_settings.toolRow();
    if (m_shownTool != row.id) {
        m_shownTool = row.id;
        qDeleteAll(m_toolParameters->parentWidget()->findChildren<NumberSlider*>("tool-parameter"));
        m_parameters.clear();
        for (const auto& p : row.parameters) {
            auto* slider = new NumberSlider(p.label, p.tip, {p.min, p.max, false, 3, p.unit});
            slider->setObjectName("tool-parameter");
            connect(slider, &NumberSlider::edited, this,
                    [this, id = std::string(p.id)](double value) { editParameter(id, value); });
            m_toolParameters->addWidget(slider);
            m_parameters[p.id] = slider;
        }
        m_toolHeading->setText(row.label);
        m_toolHeading->setVisible(!row.parameters.empty());
    }
    const ToolChoice choice = m_settings.choice(row);
    m_strength->setValue(choice.strength);
    for (const auto& [id, slider] : m_parameters)
        slider->setValue(choice.parameters.at(id));
}

void PropertiesPanel::refresh() {
    showRadius();
    showTool();
    const auto curves = sculpt::falloffTable();
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (curves[i].falloff == m_settings.falloff)
            m_falloff->setCurrentIndex(static_cast<int>(i));
    m_spacing->setValue(m_settings.spacing);
    m_axes[0]->setChecked(m_settings.symmetry.x);
    m_axes[1]->setChecked(m_settings.symmetry.y);
    m_axes[2]->setChecked(m_settings.symmetry.z);
    m_invert->setChecked(m_settings.invert);
    m_resample->setChecked(m_settings.resample);
}

} // namespace ui
