#include "ui/window/command_dialog.h"

#include <algorithm>
#include <array>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

using nlohmann::json;

bool hasDialog(const session::CommandRow& row) {
    constexpr std::array<std::string_view, 3> elsewhere{"undo", "redo", "stroke"};
    return row.changesModel && !row.startsModel &&
           std::find(elsewhere.begin(), elsewhere.end(), row.op) == elsewhere.end();
}

static QString rangeOf(const session::CommandParameter& p) {
    if (p.max <= p.min)
        return {};
    const QString low = p.min < 1e-30 ? QString(p.min < 0 ? "" : "0") : QString::number(p.min);
    const QString high = p.max > 1e30 ? QString() : QString::number(p.max);
    return high.isEmpty() ? QString() : QObject::tr(" (%1 to %2)").arg(low, high);
}

static QString fallbackOf(const session::CommandParameter& p) {
    const QString text = QString(p.fallback).remove('"');
    return text == "null" ? QObject::tr("unchanged") : text;
}

CommandDialog::CommandDialog(const session::CommandRow& row, QWidget* parent) : QDialog(parent), m_row(row) {
    setWindowTitle(row.label);
    auto* layout = new QVBoxLayout(this);
    auto* tip = new QLabel(row.tip);
    tip->setWordWrap(true);
    layout->addWidget(tip);
    auto* form = new QFormLayout;
    for (const auto& parameter : row.parameters)
        if (std::string_view(parameter.type) != "list")
            addParameter(*form, parameter);
    layout->addLayout(form);
    m_trouble = new QLabel;
    m_trouble->setStyleSheet("color: #ff8a75;");
    m_trouble->setWordWrap(true);
    layout->addWidget(m_trouble);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(row.label);
    connect(buttons, &QDialogButtonBox::accepted, this, &CommandDialog::checkAndAccept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    setMinimumWidth(380);
}

/// A free text where anything fits; a list where there are choices, editable where numbers fit too.
void CommandDialog::addParameter(QFormLayout& form, const session::CommandParameter& p) {
    const QString type = p.type;
    QStringList choices = QString(p.choices).split(' ', Qt::SkipEmptyParts);
    if (type == "boolean")
        choices = {"on", "off"};
    QWidget* field = nullptr;
    if (choices.isEmpty()) {
        auto* line = new QLineEdit;
        line->setPlaceholderText(fallbackOf(p));
        field = line;
    } else {
        auto* box = new QComboBox;
        box->setEditable(type.startsWith("number"));
        box->addItem(*p.fallback ? tr("(%1)").arg(fallbackOf(p)) : QString());
        box->addItems(choices);
        field = box;
    }
    const QString unit = *p.unit ? QString(", %1").arg(p.unit) : QString();
    field->setToolTip(QString("%1%2%3").arg(p.tip, unit, rangeOf(p)));
    field->setObjectName(p.id);
    QString label = p.id;
    label[0] = label[0].toUpper();
    form.addRow(label.replace('-', ' '), field);
    m_fields[p.id] = field;
}

static QString enteredIn(const QWidget* field) {
    if (const auto* line = qobject_cast<const QLineEdit*>(field))
        return line->text().trimmed();
    const auto* box = qobject_cast<const QComboBox*>(field);
    const QString text = box->currentText().trimmed();
    return text.startsWith('(') ? QString() : text; // the first entry stands for the default
}

json CommandDialog::command() const {
    json out{{"op", m_row.op}};
    for (const auto& parameter : m_row.parameters) {
        const auto field = m_fields.find(parameter.id);
        const QString text = field == m_fields.end() ? QString() : enteredIn(field->second);
        if (text.isEmpty())
            continue;
        bool isWhole = false, isNumber = false;
        const long long whole = text.toLongLong(&isWhole);
        const double number = text.toDouble(&isNumber);
        out[parameter.id] = isWhole ? json(whole) : isNumber ? json(number) : json(text.toStdString());
    }
    session::complete(out);
    return out;
}

void CommandDialog::checkAndAccept() {
    try {
        command();
        accept();
    } catch (const std::exception& error) {
        m_trouble->setText(QString::fromUtf8(error.what()));
    }
}

} // namespace ui
