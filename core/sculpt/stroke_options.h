// The options of a brush beside its tool and its radius: one table, over which the panel, the settings file and the
// check of a stroke are loops.
//
// Symmetry, radius and resampling are no rows: they are the same whichever tool is chosen.
#pragma once

#include "core/sculpt/stroke_settings.h"

#include <variant>

namespace sculpt {

/// What belongs together, in the order in which a person looks for it.
enum class OptionGroup { Brush, Falloff, Stroke, Area, Pressure, Stamp };

struct OptionGroupRow {
    OptionGroup group;
    const char* id;
    const char* label;
    bool open; ///< shown where nobody has said otherwise
};
std::span<const OptionGroupRow> optionGroupTable();

using OptionField =
    std::variant<float StrokeSettings::*, bool StrokeSettings::*, std::string StrokeSettings::*,
                 CurvePoints StrokeSettings::*, Falloff StrokeSettings::*, StrokeMethod StrokeSettings::*>;

/// Of a field in shown units: what is stored times `scale`.
struct OptionRange {
    double min = 0, max = 1;  ///< beyond these a stroke is refused
    double low = 0, high = 1; ///< what a slider spans
    bool logarithmic = false;
    double scale = 1;
};

struct StrokeOption {
    const char* id; ///< as sessions name it: "auto-smooth"
    const char* label;
    const char* unit; ///< "" for a plain number
    const char* tip;
    OptionGroup group;
    OptionField field;
    /// It has a say with this tool and these other options.
    bool (*applies)(const ToolRow& tool, const StrokeSettings& settings);
    OptionRange range = {}; ///< of numbers
};
std::span<const StrokeOption> strokeOptionTable();

/// What a stroke of this tool is where nobody has set anything: complete with the tool's own parameters.
StrokeSettings defaultsOf(const ToolRow& tool);

/// The three parameters by which a tool knows where to copy from, seen from the stroke's first contact: "x", "y", "z".
bool hasSource(const ToolRow& tool);

} // namespace sculpt
