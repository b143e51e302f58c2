// A whole file as read-only bytes in memory. It is opened and read once: pipes are as good as files, and whoever writes
// or cuts the file later changes nothing (a mapped file would end the program then).
//
// Opening throws base::Error where the file is missing, a folder, unreadable or empty, grows shorter while it is read,
// or is no file and goes on for more than `longestStream`. Any number of threads may read.
#pragma once

#include "core/base/large_array.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

class FileBytes {
  public:
    /// What comes through a pipe or from a device may be so long.
    static constexpr std::size_t longestStream = std::size_t(1) << 30;

    explicit FileBytes(const std::filesystem::path& path);
    /// Bytes that were made of those of a file, under its name.
    FileBytes(std::filesystem::path path, std::string content)
        : m_path(std::move(path)), m_shown(m_path), m_stream(std::move(content)), m_bytes(m_stream) {}
    /// The same where the name that tells the format is not the one that messages have to tell.
    FileBytes(std::filesystem::path path, std::string content, std::filesystem::path shown)
        : m_path(std::move(path)), m_shown(std::move(shown)), m_stream(std::move(content)), m_bytes(m_stream) {}
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    std::string_view bytes() const { return m_bytes; }
    std::size_t size() const { return m_bytes.size(); }

    /// Throws base::Error(what, "PATH", todo).
    [[noreturn]] void fail(const std::string& what, const std::string& todo = {}) const;
    /// The same with the line, counted from 1, in which the byte at `offset` stands.
    [[noreturn]] void failAt(std::size_t offset, const std::string& what, const std::string& todo = {}) const;
    /// The same with the offset itself, for binary bodies.
    [[noreturn]] void failAtByte(std::size_t offset, const std::string& what, const std::string& todo = {}) const;

  private:
    void load(int descriptor);
    void readFile(int descriptor, std::size_t size);
    void readStream(int descriptor);
    [[noreturn]] void failToRead(int code) const;

    std::filesystem::path m_path, m_shown; ///< the second one in messages
    std::string m_stream;                  ///< holds the bytes of what is no file
    base::LargeArray<char> m_file;         ///< of a file
    std::string_view m_bytes;
};

/// Some bytes of a file as they can stand in a message: at most 40 characters, unprintable ones as '?'.
std::string inQuotes(std::string_view bytes);

} // namespace io
