#include "ui/panels/measure_bar.h"

#include "ui/work/ruler_table.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace ui {

MeasureBar::MeasureBar(QWidget* parent) : QToolBar(tr("Measure"), parent), m_rows(new QButtonGroup(this)) {
    setObjectName("measure");
    setMovable(false);
    auto* panel = new QWidget;
    auto* grid = new QGridLayout(panel);
    grid->setContentsMargins(4, 2, 4, 2);
    grid->setSpacing(6);
    addWidget(panel);
    auto* buttons = new QHBoxLayout;
    grid->addLayout(buttons, 0, 0);
    const auto add = [buttons](const QString& label, const QString& tip, const QString& name) {
        auto* out = new QToolButton;
        out->setText(label);
        out->setToolTip(tip);
        out->setObjectName("measure-" + name);
        out->setFocusPolicy(Qt::NoFocus);
        buttons->addWidget(out);
        return out;
    };
    m_rows->setExclusive(false);
    for (const RulerRow& row : rulerTable()) {
        QToolButton* each = add(tr(row.label), tr(row.tip), row.id);
        each->setCheckable(true);
        m_rows->addButton(each, static_cast<int>(m_rows->buttons().size()));
    }
    connect(m_rows, &QButtonGroup::idClicked, this, [this](int id) {
        const int chosen = m_rows->button(id)->isChecked() ? id : -1;
        setRow(chosen);
        Q_EMIT rowChosen(chosen);
    });
    QToolButton* copy = add(tr("Copy"), tr("All results to the clipboard, a line each"), "copy");
    QToolButton* clear = add(tr("Clear"), tr("Takes the results off the picture"), "clear");
    connect(copy, &QToolButton::clicked, this, &MeasureBar::copyWanted);
    connect(clear, &QToolButton::clicked, this, &MeasureBar::clearWanted);
    buttons->addStretch();
    m_said = new QLabel(tr("Choose what to measure, then click on the model."));
    m_said->setObjectName("measure-said");
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(m_said, 1, 0);
}

int MeasureBar::row() const {
    for (QAbstractButton* each : m_rows->buttons())
        if (each->isChecked())
            return m_rows->id(each);
    return -1;
}

void MeasureBar::setRow(int row) {
    for (QAbstractButton* each : m_rows->buttons())
        each->setChecked(m_rows->id(each) == row);
}

void MeasureBar::say(const QString& text) {
    m_said->setText(text);
}

QString MeasureBar::said() const {
    return m_said->text();
}

} // namespace ui
