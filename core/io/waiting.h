// System calls that may wait, as for the other end of a pipe: they go on after a signal, unless that has asked the work
// to stop (base::CancelScope), and answer as `open` and `read` do, with errno. Throws base::Cancelled.
#pragma once

#include <filesystem>
#include <sys/types.h>

namespace io {

/// A descriptor for reading that programs started from here do not inherit, or -1.
int openToRead(const std::filesystem::path& path);
/// How many bytes came, 0 at the end, or -1.
ssize_t readSome(int descriptor, char* out, std::size_t size);

} // namespace io
