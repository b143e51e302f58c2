#include "ui/panels/select_bar.h"

#include <nlohmann/json.hpp>
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QToolButton>

namespace ui {

static QToolButton* button(const QString& label, const QString& tip, const QString& name) {
    auto* out = new QToolButton;
    out->setText(label);
    out->setToolTip(tip);
    out->setObjectName("select-" + name);
    out->setFocusPolicy(Qt::NoFocus);
    return out;
}

SelectBar::SelectBar(std::span<const SelectChoice> ways, QWidget* parent)
    : QToolBar(tr("Select"), parent), m_ways(new QButtonGroup(this)) {
    setObjectName("select");
    setMovable(false);
    auto* panel = new QWidget; // two rows: as wide as the other bars
    auto* grid = new QGridLayout(panel);
    grid->setContentsMargins(4, 2, 4, 2);
    grid->setSpacing(6);
    addWidget(panel);
    addWays(ways, *grid);
    addChanges(*grid);
}

/// At most one is down, and a click on it lets go of it.
void SelectBar::addWays(std::span<const SelectChoice> ways, QGridLayout& grid) {
    auto* row = new QHBoxLayout;
    m_ways->setExclusive(false);
    for (const SelectChoice& way : ways) {
        QToolButton* each = button(tr(way.label), tr(way.tip), way.id);
        each->setCheckable(true);
        m_ways->addButton(each, static_cast<int>(m_ways->buttons().size()));
        row->addWidget(each);
    }
    connect(m_ways, &QButtonGroup::idClicked, this, [this](int id) {
        const int chosen = m_ways->button(id)->isChecked() ? id : -1;
        setWay(chosen);
        Q_EMIT wayChosen(chosen);
    });
    m_mode = new QComboBox;
    m_mode->setObjectName("select-mode");
    m_mode->setFocusPolicy(Qt::NoFocus);
    m_mode->setToolTip(tr("How it joins what is selected; Shift held adds, Ctrl subtracts, both keep what is common"));
    m_mode->addItem(tr("Replace"), "replace");
    m_mode->addItem(tr("Add"), "add");
    m_mode->addItem(tr("Subtract"), "subtract");
    m_mode->addItem(tr("Intersect"), "intersect");
    row->addWidget(m_mode);
    m_visible = new QCheckBox(tr("Visible Only"));
    m_visible->setObjectName("select-visible");
    m_visible->setFocusPolicy(Qt::NoFocus);
    m_visible->setToolTip(tr("Outlines take only what is seen; else through everything"));
    row->addWidget(m_visible);
    row->addStretch();
    grid.addLayout(row, 0, 0);
}

void SelectBar::addChanges(QGridLayout& grid) {
    struct Change {
        const char *name, *label, *tip;
        nlohmann::json command; ///< null: it takes a length
    };
    const Change changes[] = {
        {"all", QT_TR_NOOP("All"), QT_TR_NOOP("Select everything"), {{"op", "select"}, {"by", "all"}}},
        {"none", QT_TR_NOOP("None"), QT_TR_NOOP("Select nothing"), {{"op", "select"}, {"by", "none"}}},
        {"invert",
         QT_TR_NOOP("Invert"),
         QT_TR_NOOP("Select what is not selected, and the other way round"),
         {{"op", "selection"}, {"do", "invert"}}},
        {"grow", QT_TR_NOOP("Grow"), QT_TR_NOOP("By half the brush's radius along the surface"), nullptr},
        {"shrink", QT_TR_NOOP("Shrink"), QT_TR_NOOP("By half the brush's radius along the surface"), nullptr},
        {"delete", QT_TR_NOOP("Delete"), QT_TR_NOOP("Take out what is selected"), {{"op", "delete"}}},
        {"keep", QT_TR_NOOP("Keep"), QT_TR_NOOP("Take out all that is not selected"), {{"op", "keep"}}},
        {"mask",
         QT_TR_NOOP("Mask"),
         QT_TR_NOOP("Protect what is selected from tools"),
         {{"op", "mask"}, {"do", "copy"}}},
        {"from-mask",
         QT_TR_NOOP("From Mask"),
         QT_TR_NOOP("Select what is protected from tools"),
         {{"op", "selection"}, {"do", "copy"}}},
    };
    auto* row = new QHBoxLayout;
    for (const Change& change : changes) {
        QToolButton* each = button(tr(change.label), tr(change.tip), change.name);
        row->addWidget(each);
        connect(each, &QToolButton::clicked, this, [this, name = QString(change.name), command = change.command] {
            if (command.is_null())
                Q_EMIT stepWanted(name);
            else
                Q_EMIT wanted(command);
        });
    }
    row->addStretch();
    grid.addLayout(row, 1, 0);
}

int SelectBar::way() const {
    for (QAbstractButton* each : m_ways->buttons())
        if (each->isChecked())
            return m_ways->id(each);
    return -1;
}

void SelectBar::setWay(int way) {
    for (QAbstractButton* each : m_ways->buttons())
        each->setChecked(m_ways->id(each) == way);
}

QString SelectBar::mode() const {
    return m_mode->currentData().toString();
}

bool SelectBar::visibleOnly() const {
    return m_visible->isChecked();
}

} // namespace ui
