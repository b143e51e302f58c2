// Every action of the menus by a few letters of its name: F3 or Ctrl+K, type, Enter. It loops over the menu bar, so
// that whatever a menu offers is here, with its way there and its keys. Interface's thread only.
#pragma once

#include <QDialog>
#include <QPointer>
#include <vector>

class QAction;
class QLineEdit;
class QMenuBar;
class QTreeWidget;

namespace ui {

/// An entry of a menu: what it is called, through which menus one comes to it ("View > Shading"), and what else it is
/// called (other_words.h).
struct PaletteEntry {
    QString label, way;
    QPointer<QAction> action;
    QString others = {};
};

/// Of all menus and those in them, in their order; separators and menus themselves are none.
std::vector<PaletteEntry> paletteEntries(const QMenuBar& bar);

/// How well words fit an entry: every one has to occur in its label, its way, what it says of itself or its other
/// words; more for beginnings of words of the label.
/// 0: not at all.
int fitOf(const PaletteEntry& entry, const QString& typed);

class CommandPalette : public QDialog {
    Q_OBJECT
  public:
    CommandPalette(const QMenuBar& bar, QWidget* parent);
    /// Labels as they are shown now, the best first.
    QStringList shown() const;

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void filter(const QString& typed);
    void run();

    std::vector<PaletteEntry> m_entries;
    QLineEdit* m_typed;
    QTreeWidget* m_list;
};

} // namespace ui
