#include "ui/panels/measure_bar.h"

#include "ui/panels/action_rows.h"
#include "ui/work/ruler_table.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {

MeasureBar::MeasureBar(QWidget* parent) : QToolBar(tr("Measure"), parent) {
    setObjectName("measure");
    setMovable(false);
    auto* panel = new QWidget;
    auto* grid = new QGridLayout(panel);
    grid->setContentsMargins(4, 2, 4, 2);
    grid->setSpacing(6);
    addWidget(panel);
    for (const RulerRow& row : rulerTable()) {
        QAction* each = barAction(*this, tr(row.label), tr(row.tip), row.id);
        each->setCheckable(true);
        m_rows << each;
        connect(each, &QAction::triggered, this, [this, id = static_cast<int>(m_rows.size()) - 1](bool on) {
            setRow(on ? id : -1);
            Q_EMIT rowChosen(on ? id : -1);
        });
    }
    m_results << barAction(*this, tr("Copy"), tr("All results to the clipboard, a line each"), "copy")
              << barAction(*this, tr("Clear"), tr("Takes the results off the picture"), "clear");
    connect(m_results[0], &QAction::triggered, this, &MeasureBar::copyWanted);
    connect(m_results[1], &QAction::triggered, this, &MeasureBar::clearWanted);
    auto* buttons = new QHBoxLayout;
    addButtons(*buttons, m_rows);
    addGap(*buttons);
    addButtons(*buttons, m_results);
    buttons->addStretch();
    grid->addLayout(buttons, 0, 0);
    m_said = new QLabel(tr("Choose what to measure, then click on the model."));
    m_said->setObjectName("measure-said");
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(m_said, 1, 0);
}

int MeasureBar::row() const {
    return checkedOf(m_rows);
}

void MeasureBar::setRow(int row) {
    checkOnly(m_rows, row);
}

void MeasureBar::say(const QString& text) {
    m_said->setText(text);
}

QString MeasureBar::said() const {
    return m_said->text();
}

} // namespace ui
