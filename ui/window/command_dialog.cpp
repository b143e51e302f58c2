#include "ui/window/command_dialog.h"

#include "core/surface/definition_options.h"
#include "ui/theme/theme.h"
#include "ui/window/fields_area.h"
#include "ui/window/file_dialogs.h"
#include "ui/window/grown_dialog.h"
#include "ui/window/parameter_values.h"
#include "ui/window/parameter_words.h"
#include "ui/window/status_line.h"
#include "ui/words/counted.h"
#include "ui/words/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

using nlohmann::json;
using session::CommandParameter;

bool hasDialog(const session::CommandRow& row) {
    constexpr std::array<std::string_view, 5> elsewhere{"undo", "redo", "stroke", "touch", "trim"};
    return row.changesModel && !row.startsModel &&
           std::find(elsewhere.begin(), elsewhere.end(), row.op) == elsewhere.end();
}

/// Commands that are to change the points alone: what they err is worth a picture.
static bool keepsSurface(const session::CommandRow& row) {
    constexpr std::array<std::string_view, 3> ops{"reduce", "refine", "resample"};
    return std::find(ops.begin(), ops.end(), row.op) != ops.end();
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

/// What says nothing takes no room.
static void tell(QLabel& label, const QString& text) {
    label.setText(text);
    label.setVisible(!text.isEmpty());
}

static QLabel* wrapped(const char* name) {
    auto* out = new QLabel;
    out->setObjectName(name);
    out->setWordWrap(true);
    return out;
}

CommandDialog::CommandDialog(const session::CommandRow& row, const Snapshot& model, QWidget* parent,
                             const std::optional<base::Plane>& plane)
    : QDialog(parent), m_row(row), m_model(model), m_plane(plane) {
    setWindowTitle(spoken(row.label));
    auto* layout = new QVBoxLayout(this);
    auto* tip = new QLabel(spoken(row.tip));
    tip->setWordWrap(true);
    layout->addWidget(tip);
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 4, 0);
    QString taken = "oc"; // of the buttons
    for (const auto& parameter : row.parameters)
        if (!parameter.recorded)
            add(*form, parameter, taken);
    addColumnTable(*form);
    layout->addWidget(new FieldsArea(*fields, screen()->availableSize().height()), 1);
    constexpr int lines = 2; // of help, so that the dialog keeps its size
    m_help = wrapped("faint");
    m_help->setMinimumHeight(lines * fontMetrics().lineSpacing());
    m_help->setAlignment(Qt::AlignTop);
    m_outcome = wrapped("outcome");
    m_said = wrapped("previewed");
    m_trouble = wrapped("trouble");
    m_trouble->setStyleSheet(troubleStyle(palette()));
    for (QLabel* each : {m_help, m_outcome, m_said, m_trouble})
        layout->addWidget(each);
    addAnswers(*layout);
    if (!m_fields.empty())
        m_fields.front().widget->setFocus();
    follow();
}

void CommandDialog::addAnswers(QVBoxLayout& layout) {
    m_preview = new QCheckBox(tr("Preview"));
    m_preview->setObjectName("previews");
    m_preview->setToolTip(tr("Shows in the picture what the command would make of the model, without doing it"));
    connect(m_preview, &QCheckBox::toggled, this, &CommandDialog::previewsSwitched);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(spoken(m_row.label));
    connect(buttons, &QDialogButtonBox::accepted, this, &CommandDialog::checkAndAccept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* line = new QHBoxLayout;
    line->addWidget(m_preview);
    if (keepsSurface(m_row)) {
        m_error = new QCheckBox(tr("Error in colours"));
        m_error->setObjectName("errorColours");
        m_error->setToolTip(tr("Colours the model by how far each of its points is from the surface that would come"));
        connect(m_error, &QCheckBox::toggled, this, &CommandDialog::errorSwitched);
        connect(m_preview, &QCheckBox::toggled, m_error, &QWidget::setEnabled);
        m_error->setEnabled(m_preview->isChecked());
        line->addWidget(m_error);
    }
    line->addWidget(buttons, 1);
    layout.addLayout(line);
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
    return proposalFor(m_row, p, m_model, m_plane);
}

/// Words to choose from, of which each stands for its id; editable where numbers fit too.
static QComboBox* listOf(const CommandParameter& p, const QString& present, const QString& none) {
    auto* out = new QComboBox;
    out->setEditable(QString(p.type).startsWith("number") || std::string_view(p.type) == "choices"); // one, or several
    out->setInsertPolicy(QComboBox::NoInsert);
    if (out->isEditable())
        out->setCompleter(nullptr); // its first Return would be a completion's, not the dialog's
    const QString fallback = present.isEmpty() ? fallbackOf(p) : present;
    if (fallback.isEmpty())
        out->addItem(isOptional(p) ? none : QString(), QString());
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
        const bool opens = m_row.op == std::string_view("open"); // what is left out, the file tells
        QComboBox* list = listOf(p, now, opens ? tr("(automatic)") : tr("(none)"));
        connect(list, &QComboBox::currentTextChanged, this, &CommandDialog::follow);
        return list;
    }
    auto* line = new QLineEdit(shown);
    if (isPlaces(p))
        line->setPlaceholderText("x, y, z; x, y, z; …");
    else if (type == "list" && std::string_view(p.tip).find("x,y,z") != std::string_view::npos)
        line->setPlaceholderText("x, y, z");
    else if (std::string_view(p.id) == "count" && m_model.surfels > 0)
        line->setPlaceholderText(tr("now %1").arg(counted(m_model.surfels)));
    else if (isOptional(p) && shown.isEmpty())
        line->setPlaceholderText(tr("optional"));
    connect(line, &QLineEdit::textChanged, this, &CommandDialog::follow);
    if (isOptional(p) && shown.isEmpty())
        connect(line, &QLineEdit::textEdited, this, [this, line] { giveWay(line); });
    return line;
}

/// With what fills it without typing.
QWidget* CommandDialog::lineWith(const CommandParameter& p, QLineEdit& line) {
    const bool file = isFile(p);
    if (!file && !isPlace(p) && !isPlaces(p))
        return &line;
    auto* button = new QToolButton;
    button->setObjectName("plain");
    button->setText(file ? tr("Browse…") : tr("Pick"));
    const QString field = p.id;
    if (file)
        connect(button, &QToolButton::clicked, this, [this, &line] { lookForFile(line); });
    else {
        button->setCheckable(true);
        button->setToolTip(isPlaces(p) ? tr("Then each click on the model is one place more")
                                       : tr("Then a click on the model is the place"));
        connect(button, &QToolButton::clicked, this,
                [this, field](bool on) { Q_EMIT placeWanted(on ? field : QString()); });
        m_picks[field] = button;
    }
    auto* out = new QWidget;
    auto* row = new QHBoxLayout(out);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&line, 1);
    row->addWidget(button);
    return out;
}

void CommandDialog::lookForFile(QLineEdit& line) {
    const QString file = QFileDialog::getOpenFileName(this, windowTitle(), line.text(), openFilter());
    if (!file.isEmpty())
        line.setText(file);
}

void CommandDialog::add(QFormLayout& form, const CommandParameter& p, QString& taken) {
    QWidget* field = make(p);
    const QString unit = *p.unit ? QString(", %1").arg(spoken(p.unit)) : QString();
    field->setToolTip(QString("%1%2%3").arg(spoken(p.tip), unit, rangeWords(p.min, p.max)));
    field->setObjectName(p.id);
    field->installEventFilter(this);
    auto* label = new QLabel(withMnemonic(parameterWords(m_row.op, p.id), taken) + unit);
    label->setToolTip(field->toolTip());
    label->setBuddy(field);
    auto* line = qobject_cast<QLineEdit*>(field);
    form.addRow(label, line ? lineWith(p, *line) : field);
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

/// What stands there at first is wanted, unless something else is: one of several ways to say the same.
static bool isProposal(const session::CommandRow& row, const CommandParameter& p) {
    return std::string_view(p.id) == (row.op == std::string_view("reduce") ? "ratio" : "spacing");
}

void CommandDialog::giveWay(const QWidget* by) {
    for (const Field& field : m_fields) {
        auto* line = qobject_cast<QLineEdit*>(field.widget);
        const bool gives = isProposal(m_row, *field.parameter) && isOptional(*field.parameter);
        if (!line || line == by || !gives || line->text() != field.shown || field.shown.isEmpty())
            continue;
        line->setPlaceholderText(m_row.op == std::string_view("reduce") ? tr("optional")
                                                                        : tr("now %1").arg(field.shown));
        line->clear();
    }
}

json CommandDialog::command() const {
    json out{{"op", m_row.op}};
    for (const Field& field : m_fields) {
        const QString text = enteredIn(field.widget);
        // The definition says what it is already; a proposed spacing stands until something else is given.
        const bool proposed = isProposal(m_row, *field.parameter);
        const bool asNow =
            isOptional(*field.parameter) && !edited(field) && !present(*field.parameter).isEmpty() && !proposed;
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
    return tr("About %1 points; now there are %2.")
        .arg(counted(static_cast<qulonglong>(std::round(points / unit) * unit)), counted(m_model.surfels));
}

void CommandDialog::follow() {
    if (!m_trouble) // being made
        return;
    followColumns();
    tell(*m_outcome, outcome());
    tell(*m_trouble, {});
    growToWords(*this);
    Q_EMIT changed();
}

void CommandDialog::setModel(const Snapshot& model) {
    m_model = model;
    follow();
}

/// What the field at hand is about, in full.
bool CommandDialog::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::FocusIn)
        m_help->setText(sentenceOf(static_cast<QWidget*>(object)->toolTip()));
    return QDialog::eventFilter(object, event);
}

// --- what would come ---

bool CommandDialog::previews() const {
    return m_preview->isChecked();
}

void CommandDialog::setPreviews(bool on) {
    m_preview->setChecked(on);
}

bool CommandDialog::showsError() const {
    return m_error && m_error->isChecked();
}

/// The first ones and the last one, which sums up: a list of all would push the buttons off the screen.
static QString fewOf(QStringList sentences) {
    constexpr qsizetype first = 3;
    for (QString& each : sentences)
        each = sentenceOf(each);
    const qsizetype more = sentences.size() - first - 1;
    if (more > 1) {
        const QString last = sentences.back();
        sentences = sentences.mid(0, first) << QObject::tr("… and %1 more.").arg(more) << last;
    }
    return sentences.join('\n');
}

void CommandDialog::sayPreviewed(const QString& text) {
    const QStringList all = text.split('\n', Qt::SkipEmptyParts);
    tell(*m_said, fewOf(all));
    m_said->setToolTip(all.join('\n'));
    growToWords(*this);
}

void CommandDialog::checkAndAccept() {
    try {
        command();
        accept();
    } catch (const std::exception& error) {
        tell(*m_trouble, QString::fromUtf8(error.what()));
        growToWords(*this);
    }
}

} // namespace ui
