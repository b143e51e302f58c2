// Paths in session files, which are UTF-8 text, where file systems take any bytes: a path that is not UTF-8 is written
// as a URL (file:///...%FF...), and any file URL is read as the path that it names.
#pragma once

#include <filesystem>
#include <string>

namespace session {

/// For text that is UTF-8 already: itself.
std::string pathText(const std::string& bytes);
std::filesystem::path pathOf(const std::string& text);

} // namespace session
