#include "ui/panels/select_bar.h"

#include "ui/panels/action_rows.h"
#include "ui/panels/folding_rows.h"

#include <nlohmann/json.hpp>
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>

namespace ui {

SelectBar::SelectBar(std::span<const SelectChoice> ways, QWidget* parent) : QToolBar(tr("Select"), parent) {
    setObjectName("select");
    setMovable(false);
    m_lines = new FoldingRows; // as wide as the other bars
    addWidget(m_lines);
    QHBoxLayout row[3];
    addWays(ways, row[0]);
    addGap(row[0]);
    addModes(row[0]);
    addChanges(row[1], row[2]);
    for (QHBoxLayout& each : row)
        if (each.count() > 0)
            m_lines->addLine(each);
}

void SelectBar::fitInto(int width) {
    m_lines->foldOver(width);
}

/// In the second row as far as a window of 1280 pixels has room; a language with longer words needs a third.
void SelectBar::addGroups(const std::vector<QList<QAction*>>& groups, QHBoxLayout& second, QHBoxLayout& third) {
    constexpr qsizetype room = 72; // letters: there is no style sheet yet that would say how wide buttons are
    QHBoxLayout* row = &second;
    qsizetype used = 0;
    for (const QList<QAction*>& each : groups) {
        for (const QAction* action : each)
            used += action->text().size();
        if (row == &second && used > room)
            row = &third;
        else if (row->count() > 0)
            addGap(*row);
        addButtons(*row, each);
    }
}

/// At most one is down, and a click on it lets go of it.
void SelectBar::addWays(std::span<const SelectChoice> ways, QHBoxLayout& row) {
    for (const SelectChoice& way : ways) {
        QAction* each = barAction(*this, tr(way.label), tr(way.tip), way.id);
        each->setCheckable(true);
        m_ways << each;
        connect(each, &QAction::triggered, this, [this, id = static_cast<int>(m_ways.size()) - 1](bool on) {
            setWay(on ? id : -1);
            Q_EMIT wayChosen(on ? id : -1);
        });
    }
    addButtons(row, m_ways);
}

void SelectBar::addModes(QHBoxLayout& row) {
    m_mode = new QComboBox;
    m_mode->setObjectName("select-mode");
    m_mode->setAccessibleName(tr("How it joins what is selected"));
    m_mode->setFocusPolicy(Qt::NoFocus);
    m_mode->setToolTip(tr("How it joins what is selected; Shift held adds, Ctrl subtracts, both keep what is common"));
    m_mode->addItem(tr("Replace"), "replace");
    m_mode->addItem(tr("Add"), "add");
    m_mode->addItem(tr("Subtract"), "subtract");
    m_mode->addItem(tr("Intersect"), "intersect");
    row.addWidget(m_mode);
    m_visible =
        barAction(*this, tr("Visible Only"), tr("Outlines take only what is seen; else through everything"), "visible");
    m_visible->setCheckable(true);
    addButtons(row, {m_visible});
}

void SelectBar::addChanges(QHBoxLayout& second, QHBoxLayout& third) {
    struct Change {
        const char *name, *label, *tip;
        nlohmann::json command; ///< null: it takes a length
        const char* key = "";
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
        {"delete", QT_TR_NOOP("Delete"), QT_TR_NOOP("Take out what is selected"), {{"op", "delete"}}, "Del"},
        {"keep", QT_TR_NOOP("Keep"), QT_TR_NOOP("Take out all that is not selected"), {{"op", "keep"}}},
        {"hide",
         QT_TR_NOOP("Hide"),
         QT_TR_NOOP("Hide what is selected: tools and rays pass it by, nothing of it is lost"),
         {{"op", "hide"}},
         "H"},
        {"hide-rest",
         QT_TR_NOOP("Hide Rest"),
         QT_TR_NOOP("Hide all that is not selected"),
         {{"op", "hide"}, {"what", "rest"}},
         "Shift+H"},
        {"show", QT_TR_NOOP("Show All"), QT_TR_NOOP("Show all that is hidden"), {{"op", "show"}}, "Alt+H"},
        {"mask",
         QT_TR_NOOP("Mask"),
         QT_TR_NOOP("Protect what is selected from tools"),
         {{"op", "mask"}, {"do", "copy"}}},
        {"from-mask",
         QT_TR_NOOP("From Mask"),
         QT_TR_NOOP("Select what is protected from tools"),
         {{"op", "selection"}, {"do", "copy"}}},
    };
    for (const Change& change : changes) {
        QAction* each = barAction(*this, tr(change.label), tr(change.tip), change.name);
        each->setShortcut(QKeySequence(change.key));
        m_changes << each;
        connect(each, &QAction::triggered, this, [this, name = QString(change.name), command = change.command] {
            if (command.is_null())
                Q_EMIT stepWanted(name);
            else
                Q_EMIT wanted(command);
        });
    }
    addGroups({m_changes.mid(0, 3), m_changes.mid(3, 2), m_changes.mid(5, 5), m_changes.mid(10)}, second, third);
}

int SelectBar::way() const {
    return checkedOf(m_ways);
}

void SelectBar::setWay(int way) {
    checkOnly(m_ways, way);
}

QString SelectBar::mode() const {
    return m_mode->currentData().toString();
}

bool SelectBar::visibleOnly() const {
    return m_visible->isChecked();
}

} // namespace ui
