// The editor of keys: every action of the menus, another key for it, and whose key that is already. It edits a value
// and applies it at once; closing keeps it. Interface's thread only.
#pragma once

#include "ui/window/key_presets.h"

#include <QDialog>

class QKeySequenceEdit;
class QLabel;
class QComboBox;
class QLineEdit;
class QMenuBar;
class QTreeWidget;

namespace ui {

class KeysDialog : public QDialog {
    Q_OBJECT
  public:
    /// `keys` outlive it.
    KeysDialog(const QMenuBar& bar, Keys& keys, QWidget* parent = nullptr);

    /// Shows the action of this id and edits it; false where there is none.
    bool choose(const std::string& id);
    /// Of the chosen action: another key, or with an empty one none. Takes it from those that have it.
    void give(const QKeySequence& key);
    /// All as the menus have it.
    void reset();
    /// All as the preset has it.
    void take(const KeyPreset& preset);

  private:
    void build();
    void showPreset();
    void list();
    void showChosen();
    const PaletteEntry* chosen() const;
    void keep(const PaletteEntry& entry, const QKeySequence& key);

    std::vector<PaletteEntry> m_entries;
    Keys& m_keys;
    QComboBox* m_preset;
    QLineEdit* m_typed;
    QTreeWidget* m_list;
    QKeySequenceEdit* m_key;
    QLabel* m_conflict;
};

} // namespace ui
