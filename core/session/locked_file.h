// A file that this process holds and appends to: POSIX calls behind four functions. Inside this room only.
//
// The lock (flock) belongs to the open file and goes with the process, however it ends.
#pragma once

#include <filesystem>
#include <string_view>

namespace session {

/// Creates an empty file that nobody else can hold. Throws std::system_error.
int createLocked(const std::filesystem::path& path);
/// Appends all bytes in one go and returns when they are on the disk. Throws std::system_error.
void appendDurably(int file, std::string_view bytes);
void closeFile(int file);
/// True where another open file holds the lock of `path`.
bool isLocked(const std::filesystem::path& path);

} // namespace session
