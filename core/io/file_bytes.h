// A whole file as read-only bytes: mapped into memory, so that nothing is copied and pages can be dropped again.
//
// Opening throws base::Error where the file is missing, a folder, unreadable or empty. Files that cannot be mapped
// (pipes) are read into memory. The bytes are there as long as the object lives; truncating the file meanwhile ends the
// program, as with any mapped file. Any number of threads may read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

class FileBytes {
  public:
    explicit FileBytes(const std::filesystem::path& path);
    ~FileBytes();
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
    std::filesystem::path m_path;
    std::string_view m_bytes;
    std::string m_owned; ///< holds the bytes where they are not mapped
    void* m_mapping = nullptr;
    std::size_t m_mappedSize = 0;
};

/// Some bytes of a file as they can stand in a message: at most 40 characters, unprintable ones as '?'.
std::string inQuotes(std::string_view bytes);

} // namespace io
