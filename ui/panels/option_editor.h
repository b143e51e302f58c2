// The widget in which a person changes one option of a brush, whatever its kind: made from the option's table row.
#pragma once

#include "core/sculpt/stroke/stroke_options.h"

#include <functional>
#include <QString>

class QWidget;

namespace ui {

struct OptionEditor {
    QWidget* widget = nullptr;
    bool half = false; ///< two of these share a row
    /// Shows what the settings say, without `edit` being called.
    std::function<void(const sculpt::StrokeSettings&)> show;
};

/// Changes settings by calling `edit` with what is to be done to them.
using EditSettings = std::function<void(const std::function<void(sculpt::StrokeSettings&)>& change)>;

/// The row's tip and, where there is one, how the editor is used.
QString hintOf(const sculpt::StrokeOption& option);

OptionEditor makeOptionEditor(const sculpt::StrokeOption& option, const EditSettings& edit);
/// Of a tool's own parameter: a number or a colour.
OptionEditor makeParameterEditor(const sculpt::ToolParameter& parameter, const EditSettings& edit);

} // namespace ui
