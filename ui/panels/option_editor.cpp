#include "ui/panels/option_editor.h"

#include "ui/panels/colour_field.h"
#include "ui/panels/curve_editor.h"
#include "ui/panels/number_slider.h"
#include "ui/panels/stamp_field.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
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
        name->setFixedWidth(labelWidth);
    layout->addWidget(name);
    layout->addWidget(field, 1);
    return out;
}

static OptionEditor number(const StrokeOption& option, float StrokeSettings::*field, const EditSettings& edit) {
    const auto& range = option.range;
    const int decimals = range.high - range.low > 50 ? 0 : 2;
    auto* slider =
        new NumberSlider(QObject::tr(option.label), QObject::tr(option.tip),
                         {range.low, range.high, range.logarithmic, decimals, option.unit, range.min, range.max});
    QObject::connect(slider, &NumberSlider::edited, slider, [=, scale = range.scale](double value) {
        edit([=](StrokeSettings& s) { s.*field = static_cast<float>(value / scale); });
    });
    const auto show = [=, scale = range.scale](const StrokeSettings& s) { slider->setValue(double(s.*field) * scale); };
    return {slider, false, show};
}

static OptionEditor flag(const StrokeOption& option, bool StrokeSettings::*field, const EditSettings& edit) {
    auto* box = new QCheckBox(QObject::tr(option.label));
    QObject::connect(box, &QCheckBox::clicked, box, [=](bool on) { edit([=](StrokeSettings& s) { s.*field = on; }); });
    return {box, true, [=](const StrokeSettings& s) { box->setChecked(s.*field); }};
}

static sculpt::Falloff valueOf(const sculpt::FalloffRow& row) {
    return row.falloff;
}
static sculpt::StrokeMethod valueOf(const sculpt::MethodRow& row) {
    return row.method;
}
static const char* tipOf(const sculpt::FalloffRow&) {
    return "";
}
static const char* tipOf(const sculpt::MethodRow& row) {
    return row.tip;
}

/// One of a table's rows.
template <class Row, class Value>
static OptionEditor choice(const StrokeOption& option, std::span<const Row> rows, Value StrokeSettings::*field,
                           const EditSettings& edit) {
    auto* box = new QComboBox;
    for (const Row& row : rows) {
        box->addItem(QObject::tr(row.label));
        box->setItemData(box->count() - 1, QObject::tr(tipOf(row)), Qt::ToolTipRole);
    }
    QObject::connect(box, &QComboBox::activated, box, [=](int index) {
        edit([=](StrokeSettings& s) { s.*field = valueOf(rows[static_cast<std::size_t>(index)]); });
    });
    const auto show = [=](const StrokeSettings& s) {
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (valueOf(rows[i]) == s.*field)
                box->setCurrentIndex(static_cast<int>(i));
    };
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

OptionEditor makeOptionEditor(const StrokeOption& option, const EditSettings& edit) {
    const auto make = [&](auto field) -> OptionEditor {
        using Value = std::decay_t<decltype(std::declval<StrokeSettings&>().*field)>;
        if constexpr (std::is_same_v<Value, float>)
            return number(option, field, edit);
        else if constexpr (std::is_same_v<Value, bool>)
            return flag(option, field, edit);
        else if constexpr (std::is_same_v<Value, std::string>)
            return image(field, edit);
        else if constexpr (std::is_same_v<Value, sculpt::CurvePoints>)
            return field == &StrokeSettings::falloffCurve ? falloffCurve(edit) : curve(option, field, edit);
        else if constexpr (std::is_same_v<Value, sculpt::Falloff>)
            return choice(option, sculpt::falloffTable(), field, edit);
        else
            return choice(option, sculpt::methodTable(), field, edit);
    };
    OptionEditor out = std::visit(make, option.field);
    out.widget->setToolTip(QObject::tr(option.tip));
    out.widget->setObjectName(option.id);
    return out;
}

OptionEditor makeParameterEditor(const sculpt::ToolParameter& parameter, const EditSettings& edit) {
    const std::string id = parameter.id;
    const auto set = [=](double value) { edit([=](StrokeSettings& s) { s.parameters[id] = value; }); };
    const auto wanted = [=](const StrokeSettings& s) { return s.parameters.at(id); };
    OptionEditor out;
    if (QString(parameter.unit) == "rgb") {
        auto* field = new ColourField(QObject::tr(parameter.label));
        QObject::connect(field, &ColourField::edited, field,
                         [=] { set(static_cast<double>(field->colour().rgb() & 0xffffffu)); });
        out = {field, true, [=](const StrokeSettings& s) {
                   field->setColour(QColor::fromRgb(static_cast<QRgb>(wanted(s)) | 0xff000000u));
               }};
    } else {
        auto* slider = new NumberSlider(QObject::tr(parameter.label), {},
                                        {parameter.min, parameter.max, false, 2, parameter.unit});
        QObject::connect(slider, &NumberSlider::edited, slider, set);
        out = {slider, false, [=](const StrokeSettings& s) { slider->setValue(wanted(s)); }};
    }
    out.widget->setToolTip(QObject::tr(parameter.tip));
    out.widget->setObjectName("tool-parameter");
    return out;
}

} // namespace ui
