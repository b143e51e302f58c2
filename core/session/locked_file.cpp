#include "core/session/locked_file.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace session {

namespace fs = std::filesystem;

[[noreturn]] static void fail(int file) {
    const int error = errno;
    if (file >= 0)
        ::close(file);
    throw std::system_error(error, std::generic_category());
}

BesideFile createBeside(const fs::path& target) {
    static std::atomic<unsigned> counter = 0;
    BesideFile out;
    do { // another process with our number, long gone, may have left a file of that name
        out.path = target.string() + ".new-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
        out.file = ::open(out.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_APPEND | O_CLOEXEC, 0600);
    } while (out.file < 0 && errno == EEXIST);
    if (out.file < 0 || ::flock(out.file, LOCK_EX | LOCK_NB) != 0)
        fail(out.file);
    return out;
}

/// Whether the name still leads to the file that was opened: its holder may have put another in its place meanwhile.
static bool isStill(int file, const fs::path& path) {
    struct stat opened {
    }, named{};
    return ::fstat(file, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

int hold(const fs::path& path) {
    for (;;) {
        const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_APPEND | O_CLOEXEC, 0600);
        if (file < 0)
            fail(file);
        if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
            if (errno != EWOULDBLOCK)
                fail(file);
            ::close(file);
            return -1;
        }
        if (isStill(file, path))
            return file;
        ::close(file);
    }
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

void cutOff(int file, std::uint64_t size) {
    if (::ftruncate(file, static_cast<off_t>(size)) != 0)
        fail(-1);
}

static void copyBytes(int from, int to) {
    char buffer[1 << 16];
    for (ssize_t count; (count = ::read(from, buffer, sizeof buffer)) != 0;) {
        if (count < 0 && errno != EINTR)
            fail(-1);
        for (ssize_t done = 0; done < count;) {
            const ssize_t written = ::write(to, buffer + done, static_cast<std::size_t>(count - done));
            if (written < 0 && errno != EINTR)
                fail(-1);
            done += std::max<ssize_t>(written, 0);
        }
    }
    if (::fdatasync(to) != 0 && errno != EINVAL && errno != ENOTSUP)
        fail(-1);
}

void copyDurably(const fs::path& from, const fs::path& to) {
    const int source = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
    if (source < 0)
        fail(source);
    BesideFile copy;
    try {
        copy = createBeside(to);
        copyBytes(source, copy.file);
        fs::rename(copy.path, to);
    } catch (...) {
        std::error_code ignored;
        closeFile(source), closeFile(copy.file);
        if (!copy.path.empty())
            fs::remove(copy.path, ignored);
        throw;
    }
    closeFile(source), closeFile(copy.file);
}

void closeFile(int file) {
    if (file >= 0)
        ::close(file);
}

bool isLocked(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0)
        return false;
    const bool locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(file);
    return locked;
}

} // namespace session
