// What a folder holds, by name. Where memory is short, the standard library's directory_iterator ends the program
// instead of throwing; this throws.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace io {

/// In no order, without "." and ".."; none of a folder that cannot be read. The empty path is the working folder.
std::vector<std::string> namesIn(const std::filesystem::path& folder);

} // namespace io
