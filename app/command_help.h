// The commands of sessions as help text: a loop over the command table, and over the tools for their own parameters.
#pragma once

#include <string>

namespace app {

std::string commandHelp();

} // namespace app
