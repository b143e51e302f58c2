#include "ui/panels/tool_grid.h"

#include <algorithm>
#include <QEvent>
#include <QToolButton>

namespace ui {

ToolGrid::ToolGrid(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

void ToolGrid::add(QAction& action) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(&action);
    button->setAutoRaise(true);
    button->setIconSize({24, 24});
    button->setFocusPolicy(Qt::NoFocus);
    m_buttons.push_back(button);
    arrange();
}

QSize ToolGrid::cell() const {
    QSize out;
    for (const QToolButton* button : m_buttons)
        out = out.expandedTo(button->sizeHint());
    return out;
}

int ToolGrid::rowsOf(int columns) const {
    return (static_cast<int>(m_buttons.size()) + columns - 1) / columns;
}

int ToolGrid::heightOf(int columns) const {
    return std::max(0, rowsOf(columns) * (cell().height() + gap) - gap);
}

QSize ToolGrid::sizeHint() const {
    return {m_columns * (cell().width() + gap) - gap, heightOf(fewest)};
}

QSize ToolGrid::minimumSizeHint() const {
    return {m_columns * (cell().width() + gap) - gap, heightOf(most) - spare * rowsOf(most)};
}

bool ToolGrid::event(QEvent* event) {
    const bool done = QWidget::event(event);
    // What buttons need is known once they have the style of the bar that they came into, and another theme changes it.
    if (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest || event->type() == QEvent::StyleChange)
        arrange();
    return done;
}

void ToolGrid::resizeEvent(QResizeEvent*) {
    arrange();
}

void ToolGrid::arrange() {
    int columns = fewest;
    while (columns < most && heightOf(columns) > height())
        ++columns;
    QSize size = cell();
    if (heightOf(columns) > height())
        size.setHeight(std::max(size.height() - spare, (height() + gap) / std::max(1, rowsOf(columns)) - gap));
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const int place = static_cast<int>(i);
        const QPoint at(place % columns * (size.width() + gap), place / columns * (size.height() + gap));
        m_buttons[i]->setGeometry(QRect(at, size));
    }
    m_columns = columns;
    if (const int wide = sizeHint().width(); wide != minimumWidth() || wide != maximumWidth()) {
        setFixedWidth(wide);
        updateGeometry();
    }
}

} // namespace ui
