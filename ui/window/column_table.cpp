#include "ui/window/column_table.h"

#include "core/base/error.h"
#include "ui/theme/theme.h"
#include "ui/window/status_line.h"
#include "ui/words/words.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace ui {

/// What readers know by name; "-" is left out.
static const QStringList roles{"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "intensity", "-"};

ColumnTable::ColumnTable(QWidget* parent) : QWidget(parent), m_table(new QTableWidget), m_said(new QLabel) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table);
    layout->addWidget(m_said);
    constexpr int wide = 460; // pixels, so that some columns stand beside each other
    m_table->setObjectName("columnTable");
    m_table->setMinimumWidth(wide);
    m_table->setAccessibleName(tr("Columns of the file"));
    m_table->horizontalHeader()->hide();
    m_table->verticalHeader()->hide();
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setFocusPolicy(Qt::NoFocus); // the lists in it are what is gone through
    m_said->setObjectName("columnsSaid");
    m_said->setWordWrap(true);
    hide();
}

void ColumnTable::showFile(const QString& path, const QString& columns) {
    if (path == m_path && columns == m_columns)
        return;
    const bool same = path == m_path;
    m_path = path;
    m_columns = columns;
    const auto preview = look();
    if (preview)
        fill(*preview);
    else if (m_said->text().isEmpty() || !same) // trouble leaves the table as it is, to be mended there
        m_lists.clear();
    setVisible(!m_lists.empty());
}

/// Says what is wrong where nothing can be read.
std::optional<io::TextPreview> ColumnTable::look() {
    m_said->clear();
    try {
        const std::string columns = m_columns.toStdString();
        auto out = io::previewText(m_path.toStdString(),
                                   columns.empty() ? std::vector<std::string>() : io::columnNames(columns));
        if (out)
            say(*out);
        return out;
    } catch (const base::Error& error) {
        m_said->setText(sentenceOf(QString::fromStdString(error.message())));
        m_said->setStyleSheet(troubleStyle(palette()));
        return std::nullopt;
    }
}

QComboBox* ColumnTable::listFor(std::size_t column, const QString& name) {
    auto* list = new QComboBox;
    list->setObjectName(QString("column%1").arg(column));
    list->setAccessibleName(tr("Column %1").arg(column + 1));
    if (!roles.contains(name, Qt::CaseInsensitive))
        list->addItem(name, name);
    for (const QString& role : roles)
        list->addItem(role == "-" ? tr("(left out)") : role, role);
    list->setCurrentIndex(list->findData(roles.contains(name.toLower()) ? name.toLower() : name));
    connect(list, &QComboBox::currentIndexChanged, this, [this, column] { choose(column); });
    return list;
}

void ColumnTable::fill(const io::TextPreview& preview) {
    const auto columns = static_cast<int>(preview.columns.size()), rows = static_cast<int>(preview.rows.size());
    m_table->clear();
    m_table->setColumnCount(columns);
    m_table->setRowCount(rows + 1);
    m_lists.clear();
    m_taken.clear();
    for (int c = 0; c < columns; ++c) {
        const auto column = static_cast<std::size_t>(c);
        m_lists.push_back(listFor(column, QString::fromStdString(preview.columns[column])));
        m_taken << m_lists.back()->currentData().toString();
        m_table->setCellWidget(0, c, m_lists.back());
        for (int r = 0; r < rows; ++r) {
            const auto& row = preview.rows[static_cast<std::size_t>(r)];
            if (column < row.size())
                m_table->setItem(r + 1, c, new QTableWidgetItem(QString::fromStdString(row[column])));
        }
    }
    m_table->resizeColumnsToContents();
    m_table->resizeRowsToContents();
    constexpr int shown = 5; // rows; the others are scrolled to
    m_table->setFixedHeight(m_table->rowHeight(0) + shown * m_table->rowHeight(std::min(1, rows)) +
                            2 * m_table->frameWidth());
}

void ColumnTable::say(const io::TextPreview& preview) {
    QString said = tr("The first points span %1 by %2 by %3 units.")
                       .arg(preview.extent.x, 0, 'g', 6)
                       .arg(preview.extent.y, 0, 'g', 6)
                       .arg(preview.extent.z, 0, 'g', 6);
    for (const std::string& message : preview.messages)
        said += ' ' + sentenceOf(spokenMessage(message));
    m_said->setText(said);
    m_said->setStyleSheet(preview.sure ? QString() : troubleStyle(palette()));
}

/// Two columns cannot be the same: the other one becomes what this one was.
void ColumnTable::choose(std::size_t column) {
    const QString before = m_taken[static_cast<qsizetype>(column)], now = m_lists[column]->currentData().toString();
    for (std::size_t other = 0; other < m_lists.size(); ++other) {
        QComboBox* list = m_lists[other];
        if (other == column || now == "-" || list->currentData().toString() != now)
            continue;
        const QSignalBlocker quiet(list);
        if (list->findData(before) < 0)
            list->addItem(before, before);
        list->setCurrentIndex(list->findData(before));
    }
    m_taken.clear();
    for (const QComboBox* list : m_lists)
        m_taken << list->currentData().toString();
    m_columns = columns();
    look();
    Q_EMIT chosen(m_columns);
}

/// Names may hold blanks, which part them in the command.
QString ColumnTable::columns() const {
    QStringList out;
    for (const QString& name : m_taken)
        out << QString(name).replace(QRegularExpression("[\\s,;]+"), "_");
    return out.join(',');
}

} // namespace ui
