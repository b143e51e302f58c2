#include "ui/panels/console_panel.h"

#include "core/base/error.h"
#include "core/session/command.h"
#include "core/session/json_text.h"

#include <nlohmann/json.hpp>
#include <QCompleter>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <sstream>

namespace ui {

static nlohmann::json named(nlohmann::json command) {
    const auto op = command.is_object() ? command.find("op") : command.end();
    if (op == command.end() || !op->is_string())
        throw base::Error("the line names no command", "", R"(write NAME, or {"op":"NAME"})");
    return command;
}

nlohmann::json commandOf(const std::string& line) {
    std::istringstream in(line);
    std::string op;
    if (!(in >> op) || op.front() == '{')
        return named(session::jsonOf(line));
    nlohmann::json out = {{"op", op}};
    for (std::string word; in >> word;) {
        const std::size_t equals = word.find('=');
        if (equals == 0 || equals == std::string::npos)
            throw base::Error("'" + word + "' is not understood", "", "write NAME=VALUE, or a whole line of JSON");
        const std::string value = word.substr(equals + 1);
        try {
            out[word.substr(0, equals)] = session::jsonOf(value);
        } catch (const base::Error&) {
            out[word.substr(0, equals)] = value; // a word
        }
    }
    return out;
}

static QStringList commandNames() {
    QStringList out;
    for (const session::CommandRow& row : session::commandTable())
        out << row.op;
    return out;
}

ConsolePanel::ConsolePanel(QWidget* parent) : QWidget(parent), m_lines(new QPlainTextEdit), m_typed(new QLineEdit) {
    constexpr int kept = 2000; // lines; the session file has all
    m_lines->setReadOnly(true);
    m_lines->setMaximumBlockCount(kept);
    m_lines->setFrameShape(QFrame::NoFrame);
    m_lines->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_lines->setAccessibleName(tr("Commands so far"));
    m_typed->setPlaceholderText(tr("A command: resample spacing=0.01, or a line of JSON"));
    m_typed->setAccessibleName(tr("Command"));
    m_typed->setCompleter(new QCompleter(commandNames(), m_typed));
    m_typed->installEventFilter(this);
    connect(m_typed, &QLineEdit::returnPressed, this, &ConsolePanel::enter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_lines, 1);
    layout->addWidget(m_typed);
}

void ConsolePanel::showLine(const QString& line) {
    m_lines->appendPlainText(line);
}

void ConsolePanel::showMessage(const QString& message) {
    m_lines->appendPlainText("# " + message);
}

QString ConsolePanel::text() const {
    return m_lines->toPlainText();
}

void ConsolePanel::enter() {
    const QString line = m_typed->text().trimmed();
    if (line.isEmpty())
        return;
    if (m_before.isEmpty() || m_before.back() != line)
        m_before << line;
    m_recalled = int(m_before.size());
    m_typed->clear();
    Q_EMIT entered(line);
}

void ConsolePanel::recall(int step) {
    m_recalled = std::clamp(m_recalled + step, 0, int(m_before.size()));
    m_typed->setText(m_recalled < m_before.size() ? m_before[m_recalled] : QString());
}

bool ConsolePanel::eventFilter(QObject* object, QEvent* event) {
    if (object == m_typed && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            recall(key == Qt::Key_Up ? -1 : 1);
            return true;
        }
    }
    return QWidget::eventFilter(object, event);
}

} // namespace ui
