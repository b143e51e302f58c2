// What the columns of a text file are, chosen in the dialogs of commands that read files.
#include "ui/window/column_table.h"
#include "ui/window/command_dialog.h"

#include <QFormLayout>
#include <QLineEdit>

namespace ui {

void CommandDialog::addColumnTable(QFormLayout& form) {
    const Field* field = find("columns");
    auto* line = field && find("path") ? qobject_cast<QLineEdit*>(field->widget) : nullptr;
    if (!line)
        return;
    m_columns = new ColumnTable;
    connect(m_columns, &ColumnTable::chosen, line, &QLineEdit::setText);
    int row = 0;
    QFormLayout::ItemRole role{};
    form.getWidgetPosition(line, &row, &role);
    form.insertRow(row + 1, m_columns);
}

void CommandDialog::followColumns() {
    if (!m_columns)
        return;
    const auto textOf = [this](std::string_view id) {
        return qobject_cast<QLineEdit*>(find(id)->widget)->text().trimmed();
    };
    m_columns->showFile(textOf("path"), textOf("columns"));
}

} // namespace ui
