#include "core/io/safe_file.h"

#include "core/base/error.h"
#include "core/base/sync_folder.h"
#include "core/io/before_writing.h"
#include "core/io/folder_names.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace io {

namespace fs = std::filesystem;

SafeFile::SafeFile(const fs::path& target) : m_target(target), m_final(target) {
    std::error_code ignored;
    if (fs::exists(target, ignored)) {
        const fs::path resolved = fs::canonical(target, ignored);
        if (!resolved.empty())
            m_final = resolved;
    }
    if (fs::is_directory(m_final, ignored))
        throw base::Error("is a folder and cannot be written as a file", target.string(), "name a file inside it");
    if (fs::exists(m_final, ignored) && !fs::is_regular_file(m_final, ignored)) {
        m_descriptor = ::open(m_final.c_str(), O_WRONLY | O_CLOEXEC);
        if (m_descriptor < 0)
            fail("be opened for writing");
        return;
    }
    refuseProtected();
    openBeside();
}

/// Renaming would pass over the file's own permissions, and root is not stopped by any.
void SafeFile::refuseProtected() const {
    struct stat info {};
    if (::stat(m_final.c_str(), &info) != 0)
        return;
    if ((info.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || ::access(m_final.c_str(), W_OK) != 0)
        throw base::Error("is write-protected", m_target.string(), "allow writing (chmod u+w) or choose another name");
}

/// Removes what killed processes began for this target: `.NAME.PROCESS-NUMBER` of a process that is no more.
static void removeLeftovers(const fs::path& folder, const std::string& stem) {
    std::error_code none;
    std::vector<fs::path> left;
    for (const std::string& name : namesIn(folder)) {
        if (!name.starts_with(stem))
            continue;
        pid_t process = 0;
        const char* end = name.data() + name.size();
        const auto parsed = std::from_chars(name.data() + stem.size(), end, process);
        if (parsed.ec != std::errc() || parsed.ptr == end || *parsed.ptr != '-' || process <= 0)
            continue;
        if (std::all_of(parsed.ptr + 1, end, [](char c) { return c >= '0' && c <= '9'; }) && ::kill(process, 0) != 0 &&
            errno == ESRCH)
            left.push_back(folder / name);
    }
    for (const fs::path& each : left)
        fs::remove(each, none);
}

/// "." for a name alone.
static fs::path folderOf(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

void requireFolder(const fs::path& target, const fs::path& shown) {
    std::error_code ignored;
    if (!fs::is_directory(folderOf(target), ignored))
        throw base::Error("cannot be written, because the folder " + folderOf(target).string() + " does not exist",
                          shown.string(), "create the folder or choose another");
}

void SafeFile::openBeside() {
    requireFolder(m_final, m_target);
    const fs::path folder = folderOf(m_final);
    struct stat info {};
    const bool replaces = ::stat(m_final.c_str(), &info) == 0;
    // Short of the 255 bytes that file systems allow.
    const std::string stem = "." + m_final.filename().string().substr(0, 200) + ".";
    removeLeftovers(folder, stem);
    static std::atomic<unsigned> counter = 0;
    do { // another process with our number, long gone, may have left a file of that name
        const std::string name = stem + std::to_string(::getpid()) + "-" + std::to_string(counter++);
        m_beside = (folder / name).string();
        m_descriptor = ::open(m_beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (m_descriptor < 0 && errno == EEXIST);
    if (m_descriptor < 0) {
        m_beside.clear();
        fail("be written in this folder");
    }
    if (replaces) // best effort: the owner of a shared folder may forbid it
        static_cast<void>(::fchmod(m_descriptor, info.st_mode & 07777));
}

SafeFile::~SafeFile() {
    discard();
}

void SafeFile::discard() noexcept {
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    m_descriptor = -1;
    if (!m_beside.empty())
        ::unlink(m_beside.c_str());
    m_beside.clear();
}

void SafeFile::fail(const char* doing) const {
    const int code = errno;
    throw base::Error(std::string("cannot ") + doing + " (" + std::strerror(code) + ")", m_target.string(),
                      code == ENOSPC ? "free some space or choose another disk"
                                     : "check the permissions or choose another place");
}

void SafeFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            fail("be written");
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void SafeFile::commit() {
    if (!m_beside.empty() && ::fsync(m_descriptor) != 0)
        fail("be written to disk");
    const int descriptor = m_descriptor;
    m_descriptor = -1;
    if (::close(descriptor) != 0)
        fail("be closed");
    if (m_beside.empty())
        return;
    if (::rename(m_beside.c_str(), m_final.c_str()) != 0)
        fail("be renamed into place");
    m_beside.clear();
    base::syncFolder(m_final.parent_path());
}

bool hasOtherNames(const fs::path& target) {
    struct stat info {};
    return ::stat(target.c_str(), &info) == 0 && S_ISREG(info.st_mode) && info.st_nlink > 1;
}

void writeFile(const fs::path& target, std::string_view bytes) {
    SafeFile file(target);
    file.write(bytes);
    file.commit();
}

} // namespace io
