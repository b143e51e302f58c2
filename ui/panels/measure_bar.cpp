#include "ui/panels/measure_bar.h"

#include "ui/panels/action_rows.h"
#include "ui/panels/folding_rows.h"
#include "ui/work/ruler_table.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QLabel>

namespace ui {

MeasureBar::MeasureBar(QWidget* parent) : QToolBar(tr("Measure"), parent) {
    setObjectName("measure");
    setMovable(false);
    m_lines = new FoldingRows;
    addWidget(m_lines);
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
    QHBoxLayout buttons;
    addButtons(buttons, m_rows);
    addGap(buttons);
    addButtons(buttons, m_results);
    m_lines->addLine(buttons);
    m_said = new QLabel(tr("Choose what to measure, then click on the model."));
    m_said->setObjectName("measure-said");
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_lines->addBelow(*m_said);
}

void MeasureBar::fitInto(int width) {
    m_lines->foldOver(width);
    m_said->setWordWrap(true);
    m_said->setFixedWidth(std::min(FoldingRows::roomOver(width), 640));
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
