#include "ui/window/keys_dialog.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {

KeysDialog::KeysDialog(const QMenuBar& bar, Keys& keys, QWidget* parent)
    : QDialog(parent), m_entries(paletteEntries(bar)), m_keys(keys), m_preset(new QComboBox), m_typed(new QLineEdit),
      m_list(new QTreeWidget), m_key(new QKeySequenceEdit), m_conflict(new QLabel) {
    applyKeys(m_entries, m_keys); // and remembers what the menus gave
    build();
    list();
}

void KeysDialog::build() {
    setWindowTitle(tr("Keys"));
    resize(620, 460);
    for (const KeyPreset& each : keyPresets())
        m_preset->addItem(tr(each.label), each.id);
    m_preset->setObjectName("preset");
    m_preset->setAccessibleName(tr("Keys of all actions at once"));
    m_preset->setPlaceholderText(tr("Chosen one by one"));
    connect(m_preset, &QComboBox::activated, this,
            [this](int row) { take(keyPresets()[static_cast<std::size_t>(row)]); });
    m_typed->setPlaceholderText(tr("Search"));
    m_list->setColumnCount(3);
    m_list->setHeaderLabels({tr("Action"), tr("Menu"), tr("Key")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_key->setObjectName("key");
    m_conflict->setObjectName("hint");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* none = buttons->addButton(tr("&No key"), QDialogButtonBox::ActionRole);
    auto* all = buttons->addButton(tr("&Reset all"), QDialogButtonBox::ResetRole);
    connect(none, &QPushButton::clicked, this, [this] { give({}); });
    connect(all, &QPushButton::clicked, this, &KeysDialog::reset);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    for (QWidget* each :
         {static_cast<QWidget*>(m_preset), static_cast<QWidget*>(m_typed), static_cast<QWidget*>(m_list),
          static_cast<QWidget*>(m_key), static_cast<QWidget*>(m_conflict), static_cast<QWidget*>(buttons)})
        layout->addWidget(each);
    connect(m_typed, &QLineEdit::textChanged, this, &KeysDialog::list);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &KeysDialog::showChosen);
    connect(m_key, &QKeySequenceEdit::editingFinished, this, [this] {
        if (!m_key->keySequence().isEmpty())
            give(m_key->keySequence());
    });
    connect(m_key, &QKeySequenceEdit::keySequenceChanged, this, [this](const QKeySequence& key) {
        const PaletteEntry* entry = chosen();
        const QStringList others = entry ? conflictsOf(m_entries, *entry->action, key) : QStringList();
        m_conflict->setText(others.isEmpty() ? QString() : tr("Taken from: %1").arg(others.join(", ")));
    });
}

void KeysDialog::list() {
    const QSignalBlocker quiet(m_list);
    const PaletteEntry* before = chosen();
    m_list->clear();
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        const PaletteEntry& entry = m_entries[i];
        if (!entry.action || fitOf(entry, m_typed->text()) == 0)
            continue;
        auto* item = new QTreeWidgetItem(
            {entry.label, entry.way, QKeySequence::listToString(entry.action->shortcuts(), QKeySequence::NativeText)});
        item->setData(0, Qt::UserRole, qulonglong(i));
        m_list->addTopLevelItem(item);
        if (&entry == before)
            m_list->setCurrentItem(item);
    }
    showChosen();
    showPreset();
}

void KeysDialog::showPreset() {
    m_preset->setCurrentIndex(-1);
    for (int row = 0; row < m_preset->count(); ++row)
        if (keysOf(keyPresets()[static_cast<std::size_t>(row)], m_entries) == m_keys)
            m_preset->setCurrentIndex(row);
}

void KeysDialog::take(const KeyPreset& preset) {
    m_keys = keysOf(preset, m_entries);
    applyKeys(m_entries, m_keys);
    list();
}

const PaletteEntry* KeysDialog::chosen() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item ? &m_entries[item->data(0, Qt::UserRole).toULongLong()] : nullptr;
}

void KeysDialog::showChosen() {
    const PaletteEntry* entry = chosen();
    const QSignalBlocker quiet(m_key);
    m_key->setEnabled(entry);
    m_key->setKeySequence(entry ? entry->action->shortcut() : QKeySequence());
    m_conflict->clear();
}

bool KeysDialog::choose(const std::string& id) {
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_list->topLevelItem(row);
        if (keyIdOf(m_entries[item->data(0, Qt::UserRole).toULongLong()]) != id)
            continue;
        m_list->setCurrentItem(item);
        return true;
    }
    return false;
}

void KeysDialog::keep(const PaletteEntry& entry, const QKeySequence& key) {
    const QList<QKeySequence> own = ownKeysOf(*entry.action);
    if (key == own.value(0) && own.size() <= 1)
        m_keys.erase(keyIdOf(entry));
    else
        m_keys[keyIdOf(entry)] = key.toString(QKeySequence::PortableText).toStdString();
}

void KeysDialog::give(const QKeySequence& key) {
    const PaletteEntry* entry = chosen();
    if (!entry)
        return;
    for (const PaletteEntry& other : m_entries)
        if (other.action && other.action != entry->action && conflictsOf({other}, *entry->action, key).size() > 0)
            keep(other, {});
    keep(*entry, key);
    applyKeys(m_entries, m_keys);
    list();
}

void KeysDialog::reset() {
    m_keys.clear();
    applyKeys(m_entries, m_keys);
    list();
}

} // namespace ui
