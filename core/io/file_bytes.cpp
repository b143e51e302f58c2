#include "core/io/file_bytes.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/waiting.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace io {

static const char* const lostFile = "check the name and the permissions";

FileBytes::FileBytes(const std::filesystem::path& path) : m_path(path), m_shown(path) {
    const int descriptor = openToRead(path);
    if (descriptor < 0)
        fail(std::string("cannot be opened (") + std::strerror(errno) + ")", lostFile);
    try {
        load(descriptor);
    } catch (...) {
        ::close(descriptor);
        throw;
    }
    ::close(descriptor);
    if (m_bytes.empty())
        fail("is empty", "choose a file that holds points");
}

void FileBytes::load(int descriptor) {
    struct stat info {};
    if (::fstat(descriptor, &info) != 0)
        fail(std::string("cannot be read (") + std::strerror(errno) + ")", lostFile);
    if (S_ISDIR(info.st_mode))
        fail("is a folder", "choose a file inside it");
    if (S_ISREG(info.st_mode) && info.st_size > 0)
        readFile(descriptor, static_cast<std::size_t>(info.st_size));
    else
        readStream(descriptor);
}

void FileBytes::failToRead(int code) const {
    fail(std::string("cannot be read (") + std::strerror(code) + ")", lostFile);
}

/// Reads on where a call gave less than asked for. Returns how much there was.
static std::size_t readAt(int descriptor, char* out, std::size_t size, std::size_t offset, int& code) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t got = ::pread(descriptor, out + done, size - done, static_cast<off_t>(offset + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            code = errno;
        if (got <= 0)
            break;
        done += static_cast<std::size_t>(got);
    }
    return done;
}

/// In pieces on all cores: most of the time goes into pages that are touched for the first time.
void FileBytes::readFile(int descriptor, std::size_t size) {
    constexpr std::size_t piece = std::size_t(1) << 22;
    m_file = base::LargeArray<char>(size);
    std::atomic<int> failed = 0;
    std::atomic<bool> whole = true;
    base::parallelFor((size + piece - 1) / piece, 1, [&](std::size_t k) {
        const std::size_t begin = k * piece, wanted = std::min(piece, size - begin);
        int code = 0;
        if (readAt(descriptor, m_file.data() + begin, wanted, begin, code) < wanted)
            whole = false;
        if (code != 0)
            failed = code;
    });
    if (failed != 0)
        failToRead(failed);
    if (!whole)
        fail("became shorter while it was read", "open it again when it is written");
    m_bytes = {m_file.data(), size};
}

void FileBytes::readStream(int descriptor) {
    char block[1 << 16];
    while (true) {
        const ssize_t got = readSome(descriptor, block, sizeof block);
        if (got < 0)
            failToRead(errno);
        if (got == 0)
            break;
        if (m_stream.size() + static_cast<std::size_t>(got) > longestStream)
            fail("goes on for more than " + std::to_string(longestStream >> 20) + " MiB and is no file",
                 "save it to a file and open that");
        m_stream.append(block, static_cast<std::size_t>(got));
    }
    m_bytes = m_stream;
}

void FileBytes::fail(const std::string& what, const std::string& todo) const {
    throw base::Error(what, m_shown.string(), todo);
}

void FileBytes::failAt(std::size_t offset, const std::string& what, const std::string& todo) const {
    const std::string_view before = m_bytes.substr(0, std::min(offset, m_bytes.size()));
    auto lines = std::count(before.begin(), before.end(), '\n');
    if (lines == 0)
        lines = std::count(before.begin(), before.end(), '\r');
    throw base::Error(what, m_shown.string() + ", line " + std::to_string(lines + 1), todo);
}

void FileBytes::failAtByte(std::size_t offset, const std::string& what, const std::string& todo) const {
    throw base::Error(what, m_shown.string() + ", byte " + std::to_string(offset), todo);
}

std::string inQuotes(std::string_view bytes) {
    constexpr std::size_t most = 40;
    std::string out = "'";
    for (const char c : bytes.substr(0, most))
        out += c >= 0x20 && c < 0x7f ? c : '?';
    return out + (bytes.size() > most ? "...'" : "'");
}

} // namespace io
