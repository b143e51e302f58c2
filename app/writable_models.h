// The files that models can be written to, by their extensions: for help, and to know of a mistake before the work.
#pragma once

#include <string>

namespace app {

/// ".ply .xyz ...", in the order of the table of formats.
std::string writableExtensions();
bool isWritableModel(const std::string& path);
/// Throws UsageError where no model is written to a file of that name; for the second one scenes are models, too.
void requireModelName(const std::string& path);
void requireSceneName(const std::string& path);

} // namespace app
