// The options of a stroke beside its tool and its samples: one table. The panel, the settings file, the session's
// command and its help, the check of a stroke and the tests are loops over it: a new option is a field of
// StrokeSettings and a row of stroke_option_table.cpp.
//
//     StrokeSettings::field <- row -> editor            ui/panels/option_editor.h
//                               |---> session line     core/session/stroke_json.h: the encoding of every kind of field
//                               |---> settings file    ui/settings/settings.cpp, in the same encoding
//                               '---> check, defaults
#pragma once

#include "core/sculpt/stroke/stroke_settings.h"

#include <limits>
#include <variant>

namespace sculpt {

/// What belongs together, in the order in which a person looks for it.
enum class OptionGroup { Brush, Falloff, Stroke, Symmetry, Area, Pressure, Stamp };

struct OptionGroupRow {
    OptionGroup group;
    const char* id;
    const char* label;
    bool open; ///< shown where nobody has said otherwise
};
std::span<const OptionGroupRow> optionGroupTable();

/// The kind of a field says how its values are edited, encoded and checked.
using OptionField =
    std::variant<float StrokeSettings::*, bool StrokeSettings::*, std::string StrokeSettings::*,
                 CurvePoints StrokeSettings::*, Falloff StrokeSettings::*, StrokeMethod StrokeSettings::*,
                 base::UpAxis StrokeSettings::*, MirrorPlanes Symmetry::*, int Symmetry::*, Axis Symmetry::*>;

template <class T>
T& at(StrokeSettings& settings, T StrokeSettings::*field) {
    return settings.*field;
}
template <class T>
const T& at(const StrokeSettings& settings, T StrokeSettings::*field) {
    return settings.*field;
}
template <class T>
T& at(StrokeSettings& settings, T Symmetry::*field) {
    return settings.symmetry.*field;
}
template <class T>
const T& at(const StrokeSettings& settings, T Symmetry::*field) {
    return settings.symmetry.*field;
}

/// The rows that a field of this type is chosen from; each has value, id and label.
template <class Choice>
auto choicesOf() {
    if constexpr (std::is_same_v<Choice, Falloff>)
        return falloffTable();
    else if constexpr (std::is_same_v<Choice, StrokeMethod>)
        return methodTable();
    else if constexpr (std::is_same_v<Choice, base::UpAxis>)
        return upAxisTable();
    else
        return axisTable();
}

enum class Shown { AsStored, Degrees };

/// Of numbers, as they are shown and recorded.
struct OptionRange {
    static constexpr double aboveZero = std::numeric_limits<float>::min();
    static constexpr double largest = std::numeric_limits<float>::max();
    double min = 0, max = 1;  ///< beyond these a stroke is refused
    double low = 0, high = 1; ///< what a slider spans
    bool logarithmic = false;
    Shown shown = Shown::AsStored; ///< angles are stored in radians
};

/// What holds where nobody has said anything.
enum class Fallback {
    Field, ///< the field's own default
    Tool,  ///< each tool has another
    None   ///< every stroke must say it
};

/// For what a person's choice holds.
enum class Scope {
    Tool,     ///< each tool keeps its own
    AllTools, ///< the same whichever tool is chosen
    Stroke    ///< said stroke by stroke: not in the panel, not in the settings file
};

struct StrokeOption {
    const char* id; ///< as sessions name it: "auto-smooth"
    const char* label;
    const char* unit;    ///< "" for a plain number
    const char* tip;     ///< one sentence
    const char* gesture; ///< how a person changes it in the window, where the editor does not show that; else ""
    OptionGroup group;
    OptionField field;
    /// It has a say with this tool and these other options.
    bool (*applies)(const ToolRow& tool, const StrokeSettings& settings);
    OptionRange range = {}; ///< of numbers
    Scope scope = Scope::Tool;
    Fallback fallback = Fallback::Field;
};
/// In the order of the panel.
std::span<const StrokeOption> strokeOptionTable();

/// A number as it is shown and recorded, never beyond the range's ends where what is stored is not; and back.
double shownOf(const StrokeOption& option, float stored);
float storedOf(const StrokeOption& option, double shown);

/// Copies the options of one scope.
void copyOptions(Scope scope, const StrokeSettings& from, StrokeSettings& to);

/// What a stroke of this tool is where nobody has set anything: complete with the tool's own parameters.
StrokeSettings defaultsOf(const ToolRow& tool);

/// Where a tool that copies copies from, relative to the stroke's first contact. No effect on other tools.
void setSource(StrokeSettings& settings, const base::Vec3d& fromContact);

} // namespace sculpt
