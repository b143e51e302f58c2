#include "ui/panels/panel_group.h"

#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

PanelGroup::PanelGroup(const QString& title, bool open, QWidget* parent)
    : QWidget(parent), m_heading(new QToolButton), m_body(new QWidget), m_rows(new QGridLayout(m_body)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    m_heading->setObjectName("heading");
    m_heading->setText(title);
    m_heading->setCheckable(true);
    m_heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_heading->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_heading->setFocusPolicy(Qt::TabFocus);
    m_rows->setContentsMargins(10, 3, 10, 8);
    m_rows->setHorizontalSpacing(6);
    m_rows->setVerticalSpacing(4);
    m_rows->setColumnStretch(0, 1);
    m_rows->setColumnStretch(1, 1);
    layout->addWidget(m_heading);
    layout->addWidget(m_body);
    connect(m_heading, &QToolButton::toggled, this, [this](bool on) {
        m_heading->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        m_body->setVisible(on);
        Q_EMIT toggled(on);
    });
    m_heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    m_body->setVisible(open);
    m_heading->setChecked(open);
}

bool PanelGroup::isOpen() const {
    return m_heading->isChecked();
}

void PanelGroup::setOpen(bool open) {
    m_heading->setChecked(open);
}

void PanelGroup::add(QWidget* row) {
    m_rows->addWidget(row, m_row++, 0, 1, 2);
    m_halfFree = false;
}

void PanelGroup::addHalf(QWidget* cell) {
    if (m_halfFree)
        m_rows->addWidget(cell, m_row - 1, 1);
    else
        m_rows->addWidget(cell, m_row++, 0);
    m_halfFree = !m_halfFree;
}

} // namespace ui
