// The options of strokes in JSON, by the kind of their field: the one encoding of session lines and settings files, and
// the parameters of the command `stroke` that it fits.
//
//     number, integer   a JSON number, angles in degrees       boolean   true or false
//     choice            the row's id                            curve     [[x,y],...]
//     mirror planes     ["x","z"]                               image     its path
#pragma once

#include "core/sculpt/stroke/stroke_options.h"
#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// Of an option as a parameter of `stroke`. Its texts live as long as the program.
CommandParameter parameterOf(const sculpt::StrokeOption& option);

/// The value in a line; null where a line says nothing of it (a stamp that there is not).
nlohmann::json valueOf(const sculpt::StrokeOption& option, const sculpt::StrokeSettings& settings);
/// Throws base::Error for lists that are no curve or no axes. REQUIRES: a value that fits parameterOf(option).
void setValue(const sculpt::StrokeOption& option, const nlohmann::json& value, sculpt::StrokeSettings& settings);

/// The same as a text for settings files: JSON, without the quotation marks of a text.
std::string textOf(const sculpt::StrokeOption& option, const sculpt::StrokeSettings& settings);
/// Throws base::Error, as the command does, for what is no value of the option.
void setText(const sculpt::StrokeOption& option, std::string_view text, sculpt::StrokeSettings& settings);

} // namespace session
