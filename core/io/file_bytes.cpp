#include "core/io/file_bytes.h"

#include "core/base/error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace io {

static const char* const lostFile = "check the name and the permissions";

static std::string readAll(int descriptor, const std::filesystem::path& path) {
    std::string out;
    char block[1 << 16];
    while (true) {
        const ssize_t got = ::read(descriptor, block, sizeof block);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            throw base::Error(std::string("cannot be read (") + std::strerror(errno) + ")", path.string());
        if (got == 0)
            return out;
        out.append(block, static_cast<std::size_t>(got));
    }
}

FileBytes::FileBytes(const std::filesystem::path& path) : m_path(path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
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
    if (S_ISREG(info.st_mode) && info.st_size > 0) {
        const auto size = static_cast<std::size_t>(info.st_size);
        void* mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
        if (mapping != MAP_FAILED) {
            ::madvise(mapping, size, MADV_WILLNEED);
            m_mapping = mapping;
            m_mappedSize = size;
            m_bytes = {static_cast<const char*>(mapping), size};
            return;
        }
    }
    m_owned = readAll(descriptor, m_path);
    m_bytes = m_owned;
}

FileBytes::~FileBytes() {
    if (m_mapping)
        ::munmap(m_mapping, m_mappedSize);
}

void FileBytes::fail(const std::string& what, const std::string& todo) const {
    throw base::Error(what, m_path.string(), todo);
}

void FileBytes::failAt(std::size_t offset, const std::string& what, const std::string& todo) const {
    const std::string_view before = m_bytes.substr(0, std::min(offset, m_bytes.size()));
    auto lines = std::count(before.begin(), before.end(), '\n');
    if (lines == 0)
        lines = std::count(before.begin(), before.end(), '\r');
    throw base::Error(what, m_path.string() + ", line " + std::to_string(lines + 1), todo);
}

void FileBytes::failAtByte(std::size_t offset, const std::string& what, const std::string& todo) const {
    throw base::Error(what, m_path.string() + ", byte " + std::to_string(offset), todo);
}

std::string inQuotes(std::string_view bytes) {
    constexpr std::size_t most = 40;
    std::string out = "'";
    for (const char c : bytes.substr(0, most))
        out += c >= 0x20 && c < 0x7f ? c : '?';
    return out + (bytes.size() > most ? "...'" : "'");
}

} // namespace io
