#include "ui/window/command_palette.h"

#include "ui/window/other_words.h"
#include "ui/words/words.h"

#include <algorithm>
#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {

static QString plain(const QString& text) {
    return QString(text).remove('&');
}

static QString englishLabelOf(const QAction& action, const QString& label) {
    const QString said = action.property(inEnglish).toString();
    return said.isEmpty() ? englishOf(label) : said;
}

static void collect(const QList<QAction*>& actions, const QString& way, std::vector<PaletteEntry>& out) {
    for (QAction* action : actions) {
        const QString label = plain(action->text());
        if (QMenu* menu = action->menu()) {
            Q_EMIT menu->aboutToShow(); // some menus say then what they are about
            collect(menu->actions(), way.isEmpty() ? label : way + " > " + label, out);
        } else if (!action->isSeparator() && !label.isEmpty())
            out.push_back({label, way, action, otherWords(englishLabelOf(*action, label))});
    }
}

std::vector<PaletteEntry> paletteEntries(const QMenuBar& bar) {
    std::vector<PaletteEntry> out;
    collect(bar.actions(), {}, out);
    return out;
}

int fitOf(const PaletteEntry& entry, const QString& typed) {
    int out = 1;
    for (const QString& word : typed.split(' ', Qt::SkipEmptyParts)) {
        if (entry.label.startsWith(word, Qt::CaseInsensitive))
            out += 8;
        else if (entry.label.contains(' ' + word, Qt::CaseInsensitive))
            out += 4;
        else if (entry.label.contains(word, Qt::CaseInsensitive))
            out += 2;
        else if (!entry.way.contains(word, Qt::CaseInsensitive) && !entry.others.contains(word, Qt::CaseInsensitive) &&
                 !(entry.action && entry.action->toolTip().contains(word, Qt::CaseInsensitive)))
            return 0;
    }
    return out;
}

CommandPalette::CommandPalette(const QMenuBar& bar, QWidget* parent)
    : QDialog(parent), m_entries(paletteEntries(bar)), m_typed(new QLineEdit), m_list(new QTreeWidget) {
    setWindowTitle(tr("Find an Action"));
    setObjectName("palette");
    m_typed->setPlaceholderText(tr("What do you want to do?"));
    m_typed->setClearButtonEnabled(true);
    m_list->setHeaderHidden(true);
    m_list->setColumnCount(3);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->header()->setStretchLastSection(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_typed);
    layout->addWidget(m_list);
    resize(std::min(620, parent ? parent->width() - 40 : 620), std::min(440, parent ? parent->height() - 60 : 440));
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_typed->installEventFilter(this);
    connect(m_typed, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_typed, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(m_list, &QTreeWidget::itemClicked, this, &CommandPalette::run);
    filter({});
}

void CommandPalette::filter(const QString& typed) {
    std::vector<std::pair<int, std::size_t>> order; // best first, then as the menus have them
    for (std::size_t i = 0; i < m_entries.size(); ++i)
        if (const int fit = m_entries[i].action ? fitOf(m_entries[i], typed) : 0)
            order.emplace_back(-fit, i);
    std::sort(order.begin(), order.end());
    m_list->clear();
    for (const auto& [fit, i] : order) {
        const QAction& action = *m_entries[i].action;
        const QString mark = action.isCheckable() && action.isChecked() ? "✓ " : "";
        auto* item = new QTreeWidgetItem(
            {mark + m_entries[i].label, m_entries[i].way, action.shortcut().toString(QKeySequence::NativeText)});
        item->setData(0, Qt::UserRole, qulonglong(i));
        item->setIcon(0, action.icon());
        item->setToolTip(0, action.toolTip());
        for (int column = 1; column < 3; ++column)
            item->setForeground(column, palette().placeholderText());
        if (!action.isEnabled())
            item->setForeground(0, palette().placeholderText());
        m_list->addTopLevelItem(item);
    }
    if (m_list->topLevelItemCount() > 0)
        return m_list->setCurrentItem(m_list->topLevelItem(0));
    auto* none = new QTreeWidgetItem({tr("Nothing is named so; try another word.")});
    none->setFlags(Qt::NoItemFlags);
    m_list->addTopLevelItem(none);
}

QStringList CommandPalette::shown() const {
    QStringList out;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        if (m_list->topLevelItem(row)->flags() != Qt::NoItemFlags)
            out << m_entries[m_list->topLevelItem(row)->data(0, Qt::UserRole).toULongLong()].label;
    return out;
}

/// The line keeps the focus, and arrows go through the list.
bool CommandPalette::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(object, event);
    const int key = static_cast<QKeyEvent*>(event)->key(), rows = m_list->topLevelItemCount();
    const int step = key == Qt::Key_Down       ? 1
                     : key == Qt::Key_Up       ? -1
                     : key == Qt::Key_PageDown ? 10
                     : key == Qt::Key_PageUp   ? -10
                                               : 0;
    if (step == 0 || rows == 0)
        return QDialog::eventFilter(object, event);
    const int at = m_list->indexOfTopLevelItem(m_list->currentItem());
    m_list->setCurrentItem(m_list->topLevelItem(std::clamp(at + step, 0, rows - 1)));
    return true;
}

/// After this dialog is gone: the action may open another.
void CommandPalette::run() {
    const QTreeWidgetItem* item = m_list->currentItem();
    if (!item)
        return;
    const QPointer<QAction> action = m_entries[item->data(0, Qt::UserRole).toULongLong()].action;
    accept();
    QTimer::singleShot(0, parentWidget(), [action] {
        if (action)
            action->trigger(); // nothing where it is not enabled
    });
}

} // namespace ui
