#include "ui/window/shortcuts_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QMainWindow>
#include <QTableWidget>
#include <QVBoxLayout>

namespace ui {

std::span<const GestureRow> gestureTable() {
    static const GestureRow table[] = {
        {"Left button on the model", "Sculpt with the chosen tool; pen pressure counts"},
        {"Shift + left button", "Smooth"},
        {"Ctrl + left button", "Invert the tool"},
        {"Left button beside the model", "Turn the view"},
        {"Right button, Alt + left button", "Turn the view, on the model too"},
        {"Double-click with these",
         "Turn about that point of the surface; beside the model, about the middle of the view"},
        {"Middle button", "Pan the view"},
        {"Wheel", "Zoom towards the pointer"},
        {"W A S D, Q E, Shift, wheel", "While flying: move, down and up, faster, set the speed; Esc lands"},
        {"Hold F and move", "Brush radius"},
        {"Hold Shift+F and move", "Tool strength"},
        {"Ctrl + click with Clone", "Choose where to copy from"},
        {"Click a number", "Type a value; drag to change it, with Shift in fine steps"},
        {"Esc", "Take back the stroke in progress; stop long work"},
    };
    return table;
}

static void addRow(QTableWidget& table, const QString& keys, const QString& effect) {
    const int row = table.rowCount();
    table.insertRow(row);
    table.setItem(row, 0, new QTableWidgetItem(keys));
    table.setItem(row, 1, new QTableWidgetItem(effect));
}

ShortcutsDialog::ShortcutsDialog(const QMainWindow& window, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Shortcuts"));
    auto* table = new QTableWidget(0, 2);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->setFocusPolicy(Qt::NoFocus);
    table->setShowGrid(false);
    table->horizontalHeader()->hide();
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    table->verticalHeader()->hide();
    for (const auto& row : gestureTable())
        addRow(*table, tr(row.gesture), tr(row.effect));
    for (const QAction* action : window.findChildren<QAction*>())
        if (!action->shortcut().isEmpty())
            addRow(*table, action->shortcut().toString(QKeySequence::NativeText), action->text().remove('&'));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(table);
    layout->addWidget(buttons);
    resize(560, 620);
}

} // namespace ui
