// The files that models can be written to, by their extensions: for help, and to know of a mistake before the work.
#pragma once

#include <string>

namespace app {

/// ".ply .xyz ...", in the order of the table of formats.
std::string writableExtensions();
bool isWritableModel(const std::string& path);

} // namespace app
