// The beginning of a file of points as text, with a list above each column that says what it is: taken as opening
// would, or as a person chooses. Hidden for other files. Interface's thread only; it reads a quarter of a megabyte.
#pragma once

#include "core/io/text/text_preview.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QTableWidget;

namespace ui {

class ColumnTable : public QWidget {
    Q_OBJECT
  public:
    explicit ColumnTable(QWidget* parent = nullptr);
    /// `columns` as the command `open` takes them; empty: what the file tells. What does not fit is said below.
    void showFile(const QString& path, const QString& columns);
    /// What stands above the columns, as `open` takes it.
    QString columns() const;

  Q_SIGNALS:
    void chosen(QString columns); ///< by hand

  private:
    std::optional<io::TextPreview> look();
    void fill(const io::TextPreview& preview);
    void say(const io::TextPreview& preview);
    QComboBox* listFor(std::size_t column, const QString& name);
    void choose(std::size_t column);

    QTableWidget* m_table;
    QLabel* m_said;
    std::vector<QComboBox*> m_lists; ///< above each column
    QStringList m_taken;             ///< what stood there before the last choice
    QString m_path, m_columns;       ///< that are shown
};

} // namespace ui
