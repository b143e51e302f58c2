// Files that this process holds and appends to, and copies for its own eyes: POSIX calls behind a few functions. Inside
// this room only.
//
// The lock (flock) belongs to the open file and goes with the process, however it ends. Nothing here follows a symbolic
// link or writes into a file that somebody else has put there. What can't be done throws std::system_error.
#pragma once

#include <filesystem>
#include <string_view>

namespace session {

/// Puts a new file of these bytes in the place of `target`, held, readable by its owner alone and on the disk; a crash
/// leaves the old or the new one whole.
int replaceDurably(const std::filesystem::path& target, std::string_view bytes);
/// Opens and holds `path`, an empty new file where there is none. -1 where another open file holds it.
int hold(const std::filesystem::path& path);
/// Appends all bytes in one go and returns when they are on the disk.
void appendDurably(int file, std::string_view bytes);
/// Cuts off what stands behind the first `size` bytes.
void cutOff(int file, std::uint64_t size);
/// Replaces `to` by a copy of `from` that is on the disk.
void copyDurably(const std::filesystem::path& from, const std::filesystem::path& to);
void closeFile(int file);
/// True where another open file holds the lock of `path`.
bool isLocked(const std::filesystem::path& path);

} // namespace session
