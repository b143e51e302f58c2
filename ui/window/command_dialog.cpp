#include "ui/window/command_dialog.h"

#include "core/base/error.h"
#include "core/surface/definition_options.h"
#include "ui/theme/theme.h"
#include "ui/window/parameter_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

using nlohmann::json;
using session::CommandParameter;

bool hasDialog(const session::CommandRow& row) {
    constexpr std::array<std::string_view, 5> elsewhere{"undo", "redo", "stroke", "touch", "trim"};
    return row.changesModel && !row.startsModel &&
           std::find(elsewhere.begin(), elsewhere.end(), row.op) == elsewhere.end();
}

static QString rangeOf(const CommandParameter& p) {
    if (p.max <= p.min)
        return {};
    const QString low = p.min < 1e-30 ? QString(p.min < 0 ? "" : "0") : QString::number(p.min);
    const QString high = p.max > 1e30 ? QString() : QString::number(p.max);
    return high.isEmpty() ? QString() : QObject::tr(" (%1 to %2)").arg(low, high);
}

static QString fallbackOf(const CommandParameter& p) {
    const QString text = QString(p.fallback).remove('"');
    return text == "null" ? QString() : text;
}

static bool optional(const CommandParameter& p) {
    return std::string_view(p.fallback) == "null";
}

static QString counted(double count) {
    return QLocale::c().toString(qulonglong(count));
}

static QString enteredIn(const QWidget* field) {
    if (const auto* line = qobject_cast<const QLineEdit*>(field))
        return line->text().trimmed();
    if (const auto* box = qobject_cast<const QCheckBox*>(field))
        return box->isChecked() ? "on" : "off";
    const auto* list = qobject_cast<const QComboBox*>(field);
    const int known = list->findText(list->currentText());
    return known >= 0 ? list->itemData(known).toString() : list->currentText().trimmed();
}

CommandDialog::CommandDialog(const session::CommandRow& row, const Snapshot& model, QWidget* parent)
    : QDialog(parent), m_row(row), m_model(model) {
    setWindowTitle(row.label);
    auto* layout = new QVBoxLayout(this);
    auto* tip = new QLabel(row.tip);
    tip->setWordWrap(true);
    layout->addWidget(tip);
    auto* form = new QFormLayout;
    QString taken = "oc"; // of the buttons
    for (const auto& parameter : row.parameters)
        if (!parameter.recorded)
            add(*form, parameter, taken);
    layout->addLayout(form);
    m_outcome = new QLabel;
    m_outcome->setObjectName("outcome");
    layout->addWidget(m_outcome);
    m_trouble = new QLabel;
    m_trouble->setStyleSheet(troubleStyle(palette()));
    m_trouble->setWordWrap(true);
    layout->addWidget(m_trouble);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(row.label);
    connect(buttons, &QDialogButtonBox::accepted, this, &CommandDialog::checkAndAccept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    setMinimumWidth(420);
    follow();
}

QString CommandDialog::present(const CommandParameter& p) const {
    const std::string_view id = p.id;
    if (m_row.op == std::string_view("surface")) {
        const surface::DefinitionOption& option = surface::definitionOption(id);
        return QString::fromStdString(surface::textOf(option, m_model.surface.definition()));
    }
    if (m_row.op == std::string_view("up") && id == "axis")
        return base::upRow(m_model.up).id;
    const auto spacing = static_cast<double>(m_model.spacing);
    if (id == "spacing" && spacing > 0)
        return QString::number(spacing, 'g', 4);
    return {};
}

/// Words to choose from, of which each stands for its id; editable where numbers fit too.
static QComboBox* listOf(const CommandParameter& p, const QString& present) {
    auto* out = new QComboBox;
    out->setEditable(QString(p.type).startsWith("number"));
    const QString fallback = present.isEmpty() ? fallbackOf(p) : present;
    if (fallback.isEmpty())
        out->addItem(optional(p) ? QObject::tr("(none)") : QString(), QString());
    for (const QString& id : QString(p.choices).split(' ', Qt::SkipEmptyParts))
        out->addItem(choiceWords(id.toStdString()), id);
    const int known = out->findData(fallback);
    if (known >= 0)
        out->setCurrentIndex(known);
    else if (out->isEditable() && !fallback.isEmpty())
        out->setEditText(fallback);
    return out;
}

QWidget* CommandDialog::make(const CommandParameter& p) {
    const QString now = present(p), shown = now.isEmpty() ? fallbackOf(p) : now;
    const std::string_view type = p.type;
    if (type == "boolean") {
        auto* box = new QCheckBox;
        box->setChecked(shown == "true" || shown == "on");
        connect(box, &QCheckBox::toggled, this, &CommandDialog::follow);
        return box;
    }
    if (*p.choices) {
        QComboBox* list = listOf(p, now);
        connect(list, &QComboBox::currentTextChanged, this, &CommandDialog::follow);
        return list;
    }
    auto* line = new QLineEdit(shown);
    if (type == "list")
        line->setPlaceholderText("x, y, z");
    else if (std::string_view(p.id) == "count" && m_model.surfels > 0)
        line->setPlaceholderText(tr("now %1").arg(counted(static_cast<double>(m_model.surfels))));
    connect(line, &QLineEdit::textChanged, this, &CommandDialog::follow);
    if (optional(p) && shown.isEmpty())
        connect(line, &QLineEdit::textEdited, this, [this, line] { giveWay(line); });
    return line;
}

void CommandDialog::add(QFormLayout& form, const CommandParameter& p, QString& taken) {
    QWidget* field = make(p);
    const QString unit = *p.unit ? QString(", %1").arg(p.unit) : QString();
    field->setToolTip(QString("%1%2%3").arg(p.tip, unit, rangeOf(p)));
    field->setObjectName(p.id);
    auto* label = new QLabel(withMnemonic(parameterWords(m_row.op, p.id), taken) + unit);
    label->setToolTip(field->toolTip());
    label->setBuddy(field);
    form.addRow(label, field);
    m_fields.push_back({&p, field, enteredIn(field)});
}

const CommandDialog::Field* CommandDialog::find(std::string_view id) const {
    const auto at =
        std::find_if(m_fields.begin(), m_fields.end(), [&](const Field& each) { return each.parameter->id == id; });
    return at == m_fields.end() ? nullptr : &*at;
}

bool CommandDialog::edited(const Field& field) const {
    return enteredIn(field.widget) != field.shown;
}

void CommandDialog::giveWay(const QWidget* by) {
    const Field* spacing = find("spacing");
    auto* line = spacing ? qobject_cast<QLineEdit*>(spacing->widget) : nullptr;
    if (!line || line == by || !optional(*spacing->parameter) || line->text() != spacing->shown)
        return;
    line->setPlaceholderText(tr("now %1").arg(spacing->shown));
    line->clear();
}

static json valueOf(const CommandParameter& p, const QString& text) {
    if (std::string_view(p.type) == "list") {
        json out = json::array();
        for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
            bool isNumber = false;
            const double number = part.trimmed().toDouble(&isNumber);
            if (!isNumber)
                throw base::Error("\"" + part.trimmed().toStdString() + "\" is no number", p.id, "give x, y, z");
            out.push_back(number);
        }
        return out;
    }
    const std::string_view type = p.type;
    if (type == "text" || type == "path" || type == "paths") // "2" is a name, too
        return json(text.toStdString());
    bool isWhole = false, isNumber = false;
    const long long whole = text.toLongLong(&isWhole);
    const double number = text.toDouble(&isNumber);
    return isWhole ? json(whole) : isNumber ? json(number) : json(text.toStdString());
}

json CommandDialog::command() const {
    json out{{"op", m_row.op}};
    for (const Field& field : m_fields) {
        const QString text = enteredIn(field.widget);
        // The definition says what it is already; a proposed spacing stands until something else is given.
        const bool proposed = std::string_view(field.parameter->id) == "spacing";
        const bool asNow =
            optional(*field.parameter) && !edited(field) && !present(*field.parameter).isEmpty() && !proposed;
        if (!text.isEmpty() && !asNow)
            out[field.parameter->id] = valueOf(*field.parameter, text);
    }
    session::complete(out);
    return out;
}

QString CommandDialog::outcome() const {
    const auto number = [this](const char* id) {
        const Field* field = find(id);
        return field ? enteredIn(field->widget).toDouble() : 0.0;
    };
    const std::string_view op = m_row.op;
    const auto now = static_cast<double>(m_model.surfels), spacing = static_cast<double>(m_model.spacing);
    double points = number("count");
    if (!(points > 0) && number("spacing") > 0 && (op == "resample" || op == "refine" || op == "thin"))
        points = now * std::pow(spacing / number("spacing"), 2);
    if (!(points > 0) && op == "reduce")
        points = now * number("ratio");
    if (op == "thin")
        points = std::min(points, now);
    if (!(points >= 1) || !(points < 1e15))
        return {};
    const double unit = points >= 1000 ? std::pow(10, std::floor(std::log10(points)) - 2) : 1;
    return tr("About %1 points; now there are %2.").arg(counted(std::round(points / unit) * unit), counted(now));
}

void CommandDialog::follow() {
    if (!m_fields.empty() && m_fields.size() == m_row.parameters.size())
        m_outcome->setText(outcome());
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
