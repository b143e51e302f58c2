#include "ui/panels/properties_panel.h"

#include "ui/panels/panel_group.h"
#include "ui/panels/radius_range.h"
#include "ui/theme/icon.h"
#include "ui/words/words.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {

static QHBoxLayout* rowOf(QWidget* widget, int spacing) {
    auto* out = new QHBoxLayout(widget);
    out->setContentsMargins(0, 0, 0, 0);
    out->setSpacing(spacing);
    return out;
}

PropertiesPanel::PropertiesPanel(Settings& settings, QWidget* parent) : QScrollArea(parent), m_settings(settings) {
    m_edit = [this](const std::function<void(sculpt::StrokeSettings&)>& change) {
        change(m_settings.edit(m_settings.toolRow()));
        refresh();
        Q_EMIT edited();
    };
    m_editShared = [this](const std::function<void(sculpt::StrokeSettings&)>& change) {
        change(m_settings.shared);
        refresh();
        Q_EMIT edited();
    };
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    layout->addWidget(titleRow());
    for (const auto& row : sculpt::optionGroupTable()) {
        PanelGroup* group = addGroup(*layout, row.id, row.label, row.open);
        m_groups.emplace_back(group, row.group);
        if (row.group == sculpt::OptionGroup::Brush)
            buildBrush(*group);
        else
            fill(*group, row.group);
    }
    layout->addStretch();
    setWidget(content);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMinimumWidth(panelWidth); // wider where panels below it are
    refresh();
}

QSize PropertiesPanel::sizeHint() const {
    return {panelWidth, QScrollArea::sizeHint().height()};
}

// --- building ---

QWidget* PropertiesPanel::titleRow() {
    auto* out = new QWidget;
    auto* row = rowOf(out, 8);
    row->setContentsMargins(10, 8, 8, 6);
    m_toolIcon = new QLabel;
    m_toolName = new QLabel;
    m_toolName->setObjectName("title");
    m_reset = new QToolButton;
    m_reset->setObjectName("plain");
    m_reset->setText(tr("Reset"));
    m_reset->setToolTip(tr("This tool's options as they were at first; radius and symmetry stay."));
    connect(m_reset, &QToolButton::clicked, this, &PropertiesPanel::resetTool);
    QSizePolicy kept = m_reset->sizePolicy(); // what is below must not jump
    kept.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(kept);
    row->addWidget(m_toolIcon);
    row->addWidget(m_toolName, 1);
    row->addWidget(m_reset);
    return out;
}

PanelGroup* PropertiesPanel::addGroup(QVBoxLayout& layout, const char* id, const char* label, bool open) {
    const auto wish = m_settings.groups.find(id);
    auto* out = new PanelGroup(tr(label), wish == m_settings.groups.end() ? open : wish->second);
    out->setObjectName(QString("group-") + id);
    connect(out, &PanelGroup::toggled, this, [this, id](bool on) { m_settings.groups[id] = on; });
    layout.addWidget(out);
    return out;
}

void PropertiesPanel::fill(PanelGroup& group, sculpt::OptionGroup which) {
    for (const auto& option : sculpt::strokeOptionTable()) {
        if (option.group != which || option.scope == sculpt::Scope::Stroke)
            continue;
        const bool shared = option.scope == sculpt::Scope::AllTools;
        const OptionEditor editor = makeOptionEditor(option, shared ? m_editShared : m_edit);
        if (editor.half)
            group.addHalf(editor.widget);
        else
            group.add(editor.widget);
        m_options.push_back({&option, editor});
    }
}

void PropertiesPanel::buildBrush(PanelGroup& group) {
    group.add(radiusRow());
    m_toolParameters = new QWidget;
    (new QGridLayout(m_toolParameters))->setContentsMargins(0, 0, 0, 0);
    fill(group, sculpt::OptionGroup::Brush);
    group.add(m_toolParameters);
    m_source = new QLabel;
    m_source->setObjectName("hint");
    m_source->setWordWrap(true);
    group.add(m_source);
    showSource({});
}

QWidget* PropertiesPanel::radiusRow() {
    auto* out = new QWidget;
    auto* row = rowOf(out, 4);
    m_radius =
        new NumberSlider(tr("Radius"), tr("Radius of the brush. [ and ] change it too, or F: move, then click."), {});
    connect(m_radius, &NumberSlider::edited, this, [this](double value) {
        (m_settings.radiusUnit == RadiusUnit::Pixels ? m_settings.radiusPx : m_settings.radiusModel) = value;
        Q_EMIT edited();
    });
    m_unit = new QToolButton;
    m_unit->setObjectName("plain");
    m_unit->setFixedWidth(54);
    m_unit->setToolTip(tr("Screen: the brush keeps its size in pixels. Model: it keeps its size on the model."));
    connect(m_unit, &QToolButton::clicked, this, [this] {
        Q_EMIT unitWanted(m_settings.radiusUnit == RadiusUnit::Pixels ? RadiusUnit::Model : RadiusUnit::Pixels);
    });
    row->addWidget(m_radius, 1);
    row->addWidget(m_unit);
    return out;
}

void PropertiesPanel::buildToolParameters() {
    const auto& row = m_settings.toolRow();
    qDeleteAll(m_toolParameters->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    m_parameters.clear();
    auto& grid = static_cast<QGridLayout&>(*m_toolParameters->layout());
    grid.setSpacing(4);
    int place = 0; // in halves of a row
    for (const auto& p : row.parameters) {
        if (p.chosenOnModel())
            continue;
        const OptionEditor editor = makeParameterEditor(p, m_edit);
        const int span = editor.half ? 1 : 2;
        grid.addWidget(editor.widget, place / 2, place % 2, 1, span);
        place += span;
        m_parameters.push_back(editor);
    }
    m_toolParameters->setVisible(!m_parameters.empty());
}

void PropertiesPanel::resetTool() {
    m_settings.tools.erase(m_settings.toolRow().id);
    refresh();
    Q_EMIT edited();
}

// --- showing ---

void PropertiesPanel::setModelSize(double diagonal) {
    if (diagonal > 0 && std::isfinite(diagonal))
        m_diagonal = diagonal;
    showRadius();
}

void PropertiesPanel::showSource(const QString& place) {
    m_source->setText(place.isEmpty() ? tr("Ctrl+click on the model: where to copy from.")
                                      : tr("Copies from %1. Ctrl+click for another place.").arg(place));
}

void PropertiesPanel::showRadius() {
    const NumberRange range = radiusRange(m_settings, m_diagonal);
    const bool pixels = m_settings.radiusUnit == RadiusUnit::Pixels;
    m_unit->setText(pixels ? tr("Screen") : tr("Model"));
    m_radius->setRange(range);
    if (!pixels)
        m_settings.radiusModel = std::clamp(m_settings.radiusModel, range.min, range.max);
    m_radius->setValue(radiusOf(m_settings));
}

void PropertiesPanel::showTool() {
    const auto& row = m_settings.toolRow();
    if (m_shownTool != row.id) {
        m_shownTool = row.id;
        buildToolParameters();
        m_toolIcon->setPixmap(icon(row.icon).pixmap(20, 20));
        m_toolName->setText(spoken(row.label, "tool"));
        m_toolName->setToolTip(tr(row.tip));
        m_source->setVisible(row.needs.source);
    }
    const sculpt::StrokeSettings choice = m_settings.choice(row);
    const auto own = m_settings.tools.find(row.id);
    m_reset->setVisible(own != m_settings.tools.end() && own->second != sculpt::defaultsOf(row));
    for (const OptionEditor& editor : m_parameters)
        editor.show(choice);
    for (const Shown& shown : m_options) {
        shown.editor.widget->setVisible(shown.option->applies(row, choice));
        shown.editor.show(choice);
    }
    for (const auto& [group, which] : m_groups)
        group->setVisible(std::any_of(m_options.begin(), m_options.end(), [&, w = which](const Shown& shown) {
            return shown.option->group == w && shown.option->applies(row, choice);
        }));
}

void PropertiesPanel::refresh() {
    showRadius();
    showTool();
}

} // namespace ui
