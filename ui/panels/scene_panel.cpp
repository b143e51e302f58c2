#include "ui/panels/scene_panel.h"

#include "ui/theme/icon.h"
#include "ui/words/counted.h"

#include <nlohmann/json.hpp>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {

enum Column : int { Name, Shown, Locked };

ScenePanel::ScenePanel(QWidget* parent) : QWidget(parent), m_list(new QTreeWidget) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    addList();
    layout->addWidget(m_list, 1);
    addButtons();
}

void ScenePanel::addList() {
    m_list->setAccessibleName(tr("Models"));
    m_list->setColumnCount(3);
    m_list->setHeaderLabels({tr("Model"), tr("Shown"), tr("Locked")});
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(Shown, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(Locked, QHeaderView::ResizeToContents);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    connect(m_list, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item && m_list->indexOfTopLevelItem(item) != static_cast<int>(m_active))
            Q_EMIT wanted({{"op", "scene"}, {"do", "activate"}, {"name", nameOf(item)}});
    });
    connect(m_list, &QTreeWidget::itemChanged, this, &ScenePanel::clicked);
}

void ScenePanel::addButtons() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(4, 4, 4, 6);
    row->setSpacing(2);
    row->addWidget(button(tr("Add…"), tr("Put the models of a file beside these"), "add"));
    row->addWidget(button(tr("Copy"), tr("A copy of the active model in the same place"), "duplicate"));
    row->addWidget(button(tr("Split"), tr("What is selected becomes a model of its own"), "split"));
    for (const auto& [label, tip, name] :
         {std::tuple(tr("Join"), tr("All models that are shown and not locked go into the active one"), "join"),
          std::tuple(tr("Remove"), tr("The active model goes out of the scene"), "remove")}) {
        m_ofSeveral.push_back(button(label, tip, name));
        row->addWidget(m_ofSeveral.back());
    }
    row->addStretch(1);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

QToolButton* ScenePanel::button(const QString& label, const QString& tip, const char* name) {
    auto* out = new QToolButton;
    out->setText(label);
    out->setToolTip(tip);
    out->setObjectName(QString("scene-%1").arg(name));
    connect(out, &QToolButton::clicked, this, [this, name] { ask(name); });
    return out;
}

void ScenePanel::ask(const char* what) {
    if (what == std::string_view("add"))
        Q_EMIT fileWanted();
    else
        Q_EMIT wanted({{"op", "scene"}, {"do", what}});
}

std::string ScenePanel::nameOf(const QTreeWidgetItem* item) const {
    const int row = m_list->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item));
    return row >= 0 ? m_shown[static_cast<std::size_t>(row)].name : std::string();
}

void ScenePanel::clicked(QTreeWidgetItem* item, int column) {
    if (column == Name)
        return renamed(item);
    const bool on = item->checkState(column) == Qt::Checked;
    const char* what = column == Shown ? (on ? "show" : "hide") : (on ? "lock" : "unlock");
    Q_EMIT wanted({{"op", "scene"}, {"do", what}, {"name", nameOf(item)}});
}

void ScenePanel::renamed(QTreeWidgetItem* item) {
    const std::string now = nameOf(item), next = item->text(Name).trimmed().toStdString();
    const QSignalBlocker quiet(m_list);
    item->setText(Name, QString::fromStdString(now)); // until the command has done it
    if (next != now)
        Q_EMIT wanted({{"op", "scene"}, {"do", "rename"}, {"name", now}, {"to", next}});
}

QStringList ScenePanel::names() const {
    QStringList out;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        out << m_list->topLevelItem(row)->text(Name);
    return out;
}

void ScenePanel::show(const Snapshot& snapshot) {
    const auto same = [&] { // also what a click has changed that was refused
        for (std::size_t k = 0; k < m_shown.size(); ++k) {
            const QTreeWidgetItem& item = *m_list->topLevelItem(static_cast<int>(k));
            if ((item.checkState(Shown) == Qt::Checked) != m_shown[k].visible ||
                (item.checkState(Locked) == Qt::Checked) != m_shown[k].locked)
                return false;
        }
        return snapshot.scene == m_shown && snapshot.active == m_active &&
               m_list->indexOfTopLevelItem(m_list->currentItem()) == static_cast<int>(m_active);
    };
    if (m_list->topLevelItemCount() == static_cast<int>(m_shown.size()) && !m_shown.empty() && same())
        return;
    const QSignalBlocker quiet(m_list); // only a person's click is a wish
    m_shown = snapshot.scene;
    m_active = snapshot.active;
    m_list->clear();
    for (const SceneEntry& each : m_shown) {
        auto* item = new QTreeWidgetItem({QString::fromStdString(each.name)});
        item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
        item->setCheckState(Shown, each.visible ? Qt::Checked : Qt::Unchecked);
        item->setCheckState(Locked, each.locked ? Qt::Checked : Qt::Unchecked);
        item->setToolTip(Name, tr("%1 points; double click to rename").arg(counted(each.surfels)));
        m_list->addTopLevelItem(item);
    }
    m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(m_active)));
    for (QToolButton* each : m_ofSeveral)
        each->setEnabled(m_shown.size() > 1);
}

} // namespace ui
