// Writes a folder's list of files to disk, so that a file created, renamed or removed in it stays so through a power
// cut.
#pragma once

#include <filesystem>

namespace base {

/// The empty path is the working folder. Best effort: not every file system can sync a folder.
void syncFolder(const std::filesystem::path& folder);

} // namespace base
