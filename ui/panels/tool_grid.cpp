#include "ui/panels/tool_grid.h"

#include <algorithm>
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
    m_cell = m_cell.expandedTo(button->sizeHint());
    arrange();
}

int ToolGrid::rowsOf(int columns) const {
    return (static_cast<int>(m_buttons.size()) + columns - 1) / columns;
}

int ToolGrid::heightOf(int columns) const {
    return std::max(0, rowsOf(columns) * (m_cell.height() + gap) - gap);
}

QSize ToolGrid::sizeHint() const {
    return {m_columns * (m_cell.width() + gap) - gap, heightOf(fewest)};
}

QSize ToolGrid::minimumSizeHint() const {
    return {m_columns * (m_cell.width() + gap) - gap, heightOf(most)};
}

void ToolGrid::resizeEvent(QResizeEvent*) {
    arrange();
}

void ToolGrid::arrange() {
    int columns = fewest;
    while (columns < most && heightOf(columns) > height())
        ++columns;
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        const int place = static_cast<int>(i);
        const QPoint at(place % columns * (m_cell.width() + gap), place / columns * (m_cell.height() + gap));
        m_buttons[i]->setGeometry(QRect(at, m_cell));
    }
    if (columns != m_columns) {
        m_columns = columns;
        setFixedWidth(sizeHint().width());
        updateGeometry();
    }
}

} // namespace ui
