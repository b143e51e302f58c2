// Options of a subcommand that are parameters of a session's command: the same names, ranges and sentences.
#pragma once

#include "app/options/option_set.h"
#include "core/session/command.h"

#include <string>
#include <utility>
#include <vector>

namespace app {

/// What was given on the command line, by the command's own names.
using GivenParameters = std::vector<std::pair<std::string, std::string>>;

/// Whether that one was.
bool has(const GivenParameters& given, const std::string& name);

/// As a command's parameters: numbers where the texts are such.
nlohmann::json parametersOf(const GivenParameters& given);

/// `--sample-count` for `sample_count`. Values are checked as `op` would check them; lists are written 0,0,9, lists of
/// lists "0,0 10,5 3,8". REQUIRES: `given` outlives the command, and `parameter` is of the session's table.
Option addParameter(OptionSet command, const std::string& op, const session::CommandParameter& parameter,
                    const std::string& help, GivenParameters& given);

/// What a parameter takes, for help: its tip, its unit, its choices, its default in brackets.
std::string helpOf(const session::CommandParameter& parameter);

} // namespace app
