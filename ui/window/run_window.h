// The door to the window: everything between `pointclay` without a subcommand and the end of the event loop.
#pragma once

#include <filesystem>
#include <vector>

namespace ui {

/// Makes the application and its main window, opens the models (the first in this window, a further window for each
/// other one; a sphere of clay where there is none) and runs until the last window is closed. Returns the exit code: 1,
/// with a message, where there is no display at all.
///
/// Starts with neither GPU nor GL driver and on any Qt platform: where GL is unusable the CPU draws. The variable
/// POINTCLAY_RENDERER=gl|cpu overrides the choice. REQUIRES: no QCoreApplication exists yet.
int runWindow(int argc, char** argv, const std::vector<std::filesystem::path>& models);

} // namespace ui
