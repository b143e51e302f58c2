// The commands of sessions as help text: a loop over the command table, and over the tools for their own parameters.
#pragma once

#include "core/session/command.h"

#include <string>

namespace app {

/// "number, above 0, model units, default 1"
std::string detailsOf(const session::CommandParameter& parameter);

/// Which commands spare what is hidden: one sentence from the table.
std::string hiddenHelp();

std::string commandHelp();

} // namespace app
