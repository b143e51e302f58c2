#include "core/session/locked_file.h"

#include <algorithm>
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

namespace {

/// A held, empty file under a name of its own.
struct BesideFile {
    int file = -1;
    fs::path path;
};

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

void writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail(-1);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// Pipes and some folders cannot sync: what was written stays as safe as they make it.
void sync(int file) {
    if (::fdatasync(file) != 0 && errno != EINVAL && errno != ENOTSUP)
        fail(-1);
}

void copyAll(int from, int to) {
    char buffer[1 << 16];
    for (ssize_t count; (count = ::read(from, buffer, sizeof buffer)) != 0;) {
        if (count < 0 && errno != EINTR)
            fail(-1);
        writeAll(to, {buffer, static_cast<std::size_t>(std::max<ssize_t>(count, 0))});
    }
}

/// A new file in the place of `target`, filled and on the disk; a crash leaves the old or the new one whole.
template <class Fill>
int replaced(const fs::path& target, const Fill& fill) {
    const BesideFile next = createBeside(target);
    try {
        fill(next.file);
        sync(next.file);
        fs::rename(next.path, target);
    } catch (...) {
        closeFile(next.file);
        std::error_code ignored;
        fs::remove(next.path, ignored);
        throw;
    }
    return next.file;
}

} // namespace

int replaceDurably(const fs::path& target, std::string_view bytes) {
    return replaced(target, [&](int file) { writeAll(file, bytes); });
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
    writeAll(file, bytes);
    sync(file);
}

void cutOff(int file, std::uint64_t size) {
    if (::ftruncate(file, static_cast<off_t>(size)) != 0)
        fail(-1);
}

void copyDurably(const fs::path& from, const fs::path& to) {
    const int source = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
    if (source < 0)
        fail(source);
    try {
        closeFile(replaced(to, [&](int file) { copyAll(source, file); }));
    } catch (...) {
        closeFile(source);
        throw;
    }
    closeFile(source);
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
