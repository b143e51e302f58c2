// The program's own start, from process to frame.
#pragma once

#include <filesystem>

namespace bench {

/// Runs the program until it has drawn its first sample into a file. Throws base::Error where that fails.
void startAndDraw(const std::filesystem::path& program, const std::filesystem::path& picture);

} // namespace bench
