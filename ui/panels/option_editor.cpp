#include "ui/panels/option_editor.h"

#include "ui/panels/colour_field.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/stamp_field.h"
#include "ui/words/words.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {

/// Of names left of their fields, so that the fields stand in line.
constexpr int labelWidth = 50;

using sculpt::StrokeOption;
using sculpt::StrokeSettings;

/// A name left of or above what is edited.
static QWidget* labelled(const char* label, QWidget* field, QBoxLayout::Direction direction) {
    auto* out = new QWidget;
    auto* layout = new QBoxLayout(direction, out);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(direction == QBoxLayout::LeftToRight ? 8 : 3);
    auto* name = new QLabel(QObject::tr(label));
    name->setObjectName("faint");
    if (direction == QBoxLayout::LeftToRight)
        name->setMinimumWidth(labelWidth);
    layout->addWidget(name);
    layout->addWidget(field, 1);
    return out;
}

/// As a slider has room for.
static const char* shortUnit(const char* unit) {
    return std::string_view(unit) == "degrees" ? "°" : unit;
}

static NumberSlider* slider(const StrokeOption& option, int decimals) {
    const auto& range = option.range;
    return new NumberSlider(
        QObject::tr(option.label), QObject::tr(option.tip),
        {range.low, range.high, range.logarithmic, decimals, spoken(shortUnit(option.unit)), range.min, range.max});
}

static OptionEditor number(const StrokeOption& option, float StrokeSettings::*field, const EditSettings& edit) {
    auto* out = slider(option, option.range.high - option.range.low > 50 ? 0 : 2);
    QObject::connect(out, &NumberSlider::edited, out, [=, &option](double value) {
        edit([=, &option](StrokeSettings& s) { s.*field = storedOf(option, value); });
    });
    return {out, false, [=, &option](const StrokeSettings& s) { out->setValue(shownOf(option, s.*field)); }};
}

static OptionEditor wholeNumber(const StrokeOption& option, int sculpt::Symmetry::*field, const EditSettings& edit) {
    auto* out = slider(option, 0);
    QObject::connect(out, &NumberSlider::edited, out,
                     [=](double value) { edit([=](StrokeSettings& s) { at(s, field) = static_cast<int>(value); }); });
    return {out, true, [=](const StrokeSettings& s) { out->setValue(at(s, field)); }};
}

/// A button for each plane.
static OptionEditor planes(const StrokeOption& option, sculpt::MirrorPlanes sculpt::Symmetry::*field,
                           const EditSettings& edit) {
    using sculpt::MirrorPlanes;
    constexpr std::pair<const char*, bool MirrorPlanes::*> rows[] = {
        {"X", &MirrorPlanes::x}, {"Y", &MirrorPlanes::y}, {"Z", &MirrorPlanes::z}};
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    std::vector<std::function<void(const StrokeSettings&)>> shows;
    for (const auto& [name, plane] : rows) {
        auto* button = new QToolButton;
        button->setObjectName("plain");
        button->setText(name);
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setToolTip(
            QObject::tr("Every dab is made on both sides of the plane %1 = 0.").arg(QString(name).toLower()));
        QObject::connect(button, &QToolButton::clicked, button,
                         [=, plane = plane](bool on) { edit([=](StrokeSettings& s) { at(s, field).*plane = on; }); });
        layout->addWidget(button, 1);
        shows.push_back([=, plane = plane](const StrokeSettings& s) { button->setChecked(at(s, field).*plane); });
    }
    const auto show = [=](const StrokeSettings& s) {
        for (const auto& each : shows)
            each(s);
    };
    return {labelled(option.label, row, QBoxLayout::LeftToRight), false, show};
}

static OptionEditor flag(const StrokeOption& option, bool StrokeSettings::*field, const EditSettings& edit) {
    auto* box = new QCheckBox(QObject::tr(option.label));
    QObject::connect(box, &QCheckBox::clicked, box, [=](bool on) { edit([=](StrokeSettings& s) { s.*field = on; }); });
    return {box, true, [=](const StrokeSettings& s) { box->setChecked(s.*field); }};
}

/// What a choice says of itself, where its table does.
template <class Row>
static QString tipOf(const Row& row) {
    if constexpr (requires { row.tip; })
        return QObject::tr(row.tip);
    return {};
}

/// One of a table's rows; those of an axis need no name beside them.
template <class Choice, class Owner>
static OptionEditor choice(const StrokeOption& option, Choice Owner::*field, const EditSettings& edit) {
    const auto rows = sculpt::choicesOf<Choice>();
    auto* box = new QComboBox;
    for (const auto& row : rows) {
        box->addItem(spoken(row.label, std::is_same_v<Choice, sculpt::Falloff> ? "falloff" : "option"));
        box->setItemData(box->count() - 1, tipOf(row), Qt::ToolTipRole);
    }
    QObject::connect(box, &QComboBox::activated, box, [=](int index) {
        edit([=](StrokeSettings& s) { at(s, field) = rows[static_cast<std::size_t>(index)].value; });
    });
    const auto show = [=](const StrokeSettings& s) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].value == at(s, field))
                box->setCurrentIndex(static_cast<int>(i));
    };
    if (std::is_same_v<Choice, sculpt::Axis>)
        return {box, true, show};
    return {labelled(option.label, box, QBoxLayout::LeftToRight), false, show};
}

static OptionEditor curve(const StrokeOption& option, sculpt::CurvePoints StrokeSettings::*field,
                          const EditSettings& edit) {
    auto* editor = new CurveEditor;
    QObject::connect(editor, &CurveEditor::edited, editor,
                     [=] { edit([=, points = editor->points()](StrokeSettings& s) { s.*field = points; }); });
    const auto show = [=](const StrokeSettings& s) { editor->setPoints(s.*field); };
    return {labelled(option.label, editor, QBoxLayout::TopToBottom), false, show};
}

/// The shape of any falloff; whoever changes one makes it the custom one.
static OptionEditor falloffCurve(const EditSettings& edit) {
    auto* editor = new CurveEditor;
    QObject::connect(editor, &CurveEditor::edited, editor, [=] {
        edit([=, points = editor->points()](StrokeSettings& s) {
            s.falloff = sculpt::Falloff::Custom;
            s.falloffCurve = points;
        });
    });
    const auto show = [=](const StrokeSettings& s) {
        editor->setPoints(s.falloffCurve);
        editor->setShape(s.falloff == sculpt::Falloff::Custom ? CurveEditor::Shape()
                                                              : CurveEditor::Shape(sculpt::row(s.falloff).weight));
    };
    return {editor, false, show};
}

static OptionEditor image(std::string StrokeSettings::*field, const EditSettings& edit) {
    auto* stamp = new StampField;
    QObject::connect(stamp, &StampField::edited, stamp,
                     [=] { edit([=, path = stamp->path()](StrokeSettings& s) { s.*field = path; }); });
    return {stamp, false, [=](const StrokeSettings& s) { stamp->setPath(s.*field); }};
}

QString hintOf(const StrokeOption& option) {
    const QString tip = QObject::tr(option.tip);
    return *option.gesture ? tip + ' ' + QObject::tr(option.gesture) : tip;
}

OptionEditor makeOptionEditor(const StrokeOption& option, const EditSettings& edit) {
    const auto make = [&](auto field) -> OptionEditor {
        using Value = std::decay_t<decltype(at(std::declval<StrokeSettings&>(), field))>;
        if constexpr (std::is_same_v<Value, float>)
            return number(option, field, edit);
        else if constexpr (std::is_same_v<Value, int>)
            return wholeNumber(option, field, edit);
        else if constexpr (std::is_same_v<Value, bool>)
            return flag(option, field, edit);
        else if constexpr (std::is_same_v<Value, std::string>)
            return image(field, edit);
        else if constexpr (std::is_same_v<Value, sculpt::CurvePoints>)
            return field == &StrokeSettings::falloffCurve ? falloffCurve(edit) : curve(option, field, edit);
        else if constexpr (std::is_same_v<Value, sculpt::MirrorPlanes>)
            return planes(option, field, edit);
        else
            return choice(option, field, edit);
    };
    OptionEditor out = std::visit(make, option.field);
    out.widget->setToolTip(hintOf(option));
    out.widget->setObjectName(option.id);
    return out;
}

OptionEditor makeParameterEditor(const sculpt::ToolParameter& parameter, const EditSettings& edit) {
    const std::string id = parameter.id;
    const auto set = [=](double value) { edit([=](StrokeSettings& s) { s.parameters[id] = value; }); };
    const auto wanted = [=](const StrokeSettings& s) { return s.parameters.at(id); };
    OptionEditor out;
    if (parameter.kind == sculpt::ParameterKind::Colour) {
        auto* field = new ColourField(QObject::tr(parameter.label));
        QObject::connect(field, &ColourField::edited, field,
                         [=] { set(static_cast<double>(field->colour().rgb() & 0xffffffu)); });
        out = {field, true, [=](const StrokeSettings& s) {
                   field->setColour(QColor::fromRgb(static_cast<QRgb>(wanted(s)) | 0xff000000u));
               }};
    } else {
        auto* slider = new NumberSlider(QObject::tr(parameter.label), {},
                                        {parameter.min, parameter.max, false, 2, spoken(parameter.unit)});
        QObject::connect(slider, &NumberSlider::edited, slider, set);
        out = {slider, false, [=](const StrokeSettings& s) { slider->setValue(wanted(s)); }};
    }
    out.widget->setToolTip(QObject::tr(parameter.tip));
    out.widget->setObjectName("tool-parameter");
    return out;
}

} // namespace ui
