#include "core/session/locked_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace session {

[[noreturn]] static void fail(int file) {
    const int error = errno;
    if (file >= 0)
        ::close(file);
    throw std::system_error(error, std::generic_category());
}

int createLocked(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) != 0)
        fail(file);
    return file;
}

void appendDurably(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail(-1);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    // Pipes and some folders cannot sync: what was written stays as safe as they make it.
    if (::fdatasync(file) != 0 && errno != EINVAL && errno != ENOTSUP)
        fail(-1);
}

void closeFile(int file) {
    if (file >= 0)
        ::close(file);
}

bool isLocked(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    const bool locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(file);
    return locked;
}

} // namespace session
