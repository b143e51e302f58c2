#include "ui/panels/layer_bar.h"

#include "ui/panels/action_rows.h"
#include "ui/panels/folding_rows.h"
#include "ui/panels/number_slider.h"

#include <nlohmann/json.hpp>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>

namespace ui {

/// A slider that was not moved for so long rests.
constexpr int restMs = 120;

LayerBar::LayerBar(QWidget* parent) : QToolBar(tr("Layers"), parent), m_rest(new QTimer(this)) {
    setObjectName("layers");
    setMovable(false);
    addList();
    addStrength();
    QHBoxLayout line;
    line.addWidget(m_list);
    line.addWidget(m_strength);
    m_shown = addButton("show", tr("Shown"), tr("Show what the layer holds"));
    m_shown->setCheckable(true);
    line.addWidget(m_shown);
    addGap(line);
    line.addWidget(addButton("add", tr("Add"), tr("A new layer on top of all others; strokes then act on it")));
    m_ofLayer = {m_shown,
                 addButton("up", tr("Up"), tr("Above the layer that is above it now")),
                 addButton("down", tr("Down"), tr("Below the layer that is below it now")),
                 addButton("merge", tr("Merge"), tr("Into the layer below it, or the surface below all layers")),
                 addButton("rename", tr("Rename"), tr("Give the layer another name")),
                 addButton("remove", tr("Remove"), tr("The layer goes with what was sculpted on it"))};
    for (QToolButton* each : m_ofLayer)
        if (each != m_shown)
            line.addWidget(each);
    m_lines = new FoldingRows;
    m_lines->addLine(line);
    addWidget(m_lines);
    m_rest->setSingleShot(true);
    m_rest->setInterval(restMs);
    connect(m_rest, &QTimer::timeout, this, &LayerBar::askStrength);
    display({});
}

void LayerBar::fitInto(int width) {
    m_lines->foldOver(width);
}

void LayerBar::addList() {
    m_list = new QComboBox;
    m_list->setObjectName("layer-list");
    m_list->setToolTip(tr("The layer that strokes act on; the uppermost stands first"));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setMinimumContentsLength(10);
    connect(m_list, &QComboBox::activated, this, [this] {
        const QString name = m_list->currentData().toString();
        if (name.isEmpty())
            Q_EMIT wanted({{"op", "layer"}, {"do", "base"}});
        else
            Q_EMIT wanted({{"op", "layer"}, {"do", "activate"}, {"name", name.toStdString()}});
    });
}

void LayerBar::addStrength() {
    NumberRange range;
    range.min = double(layers::leastStrength), range.max = double(layers::mostStrength);
    m_strength = new NumberSlider(tr("Layer Strength"),
                                  tr("How much of what the layer holds is shown; below 0 the "
                                     "other way"),
                                  range);
    m_strength->setObjectName("layer-strength");
    m_strength->setFixedWidth(180);
    connect(m_strength, &NumberSlider::edited, this, [this](double value) {
        m_moved = m_stack.active, m_wish = value;
        m_rest->start();
    });
}

QToolButton* LayerBar::addButton(const char* action, const QString& label, const QString& tip) {
    auto* out = new QToolButton;
    out->setText(label);
    out->setToolTip(tip);
    out->setObjectName(QString("layer-%1").arg(action));
    out->setFocusPolicy(Qt::NoFocus);
    connect(out, &QToolButton::clicked, this, [this, action] { ask(action); });
    return out;
}

void LayerBar::ask(const char* action) {
    const int at = m_stack.target();
    const std::string_view what = action;
    if (what == "add") {
        Q_EMIT wanted({{"op", "layer"}, {"do", "add"}});
        return;
    }
    if (at < 0)
        return;
    const layers::Layer& layer = m_stack.layers[static_cast<std::size_t>(at)];
    nlohmann::json command{{"op", "layer"}, {"do", action}, {"name", layer.name}};
    if (what == "rename") {
        Q_EMIT nameWanted(QString::fromStdString(layer.name));
        return;
    }
    if (what == "show")
        command["do"] = layer.visible ? "hide" : "show";
    if (what == "up" || what == "down") {
        const int to = at + (what == "up" ? 1 : -1);
        if (to < 0 || to >= static_cast<int>(m_stack.layers.size()))
            return;
        command["do"] = "move";
        command["place"] = to + 1;
    }
    Q_EMIT wanted(command);
}

void LayerBar::askStrength() {
    if (const int at = m_stack.indexOf(m_moved); at >= 0)
        Q_EMIT wanted({{"op", "layer"},
                       {"do", "strength"},
                       {"name", m_stack.layers[static_cast<std::size_t>(at)].name},
                       {"strength", m_wish}});
}

void LayerBar::fillList(const layers::Stack& stack) {
    m_list->clear();
    for (std::size_t i = stack.layers.size(); i-- > 0;) {
        const layers::Layer& each = stack.layers[i];
        const QString name = QString::fromStdString(each.name);
        m_list->addItem(each.visible ? tr("%1  %2").arg(name).arg(double(each.strength), 0, 'f', 2)
                                     : tr("%1  hidden").arg(name),
                        name);
    }
    m_list->addItem(tr("Below all layers"), QString());
}

void LayerBar::display(const layers::Stack& stack) {
    const QSignalBlocker quiet(m_list);
    const int at = stack.target();
    if (m_list->count() == 0 || !(stack == m_stack)) // else somebody may be choosing from it
        fillList(stack);
    m_stack = stack;
    m_list->setCurrentIndex(at < 0 ? m_list->count() - 1 : static_cast<int>(stack.layers.size()) - 1 - at);
    for (QToolButton* each : m_ofLayer)
        each->setEnabled(at >= 0);
    m_strength->setEnabled(at >= 0);
    const bool shown = at >= 0 && stack.layers[static_cast<std::size_t>(at)].visible;
    m_shown->setChecked(shown);
    if (at >= 0 && !(m_rest->isActive() && m_moved == stack.active))
        m_strength->setValue(double(stack.layers[static_cast<std::size_t>(at)].strength));
}

} // namespace ui
