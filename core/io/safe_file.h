// Writing a file so that nobody ever sees half of it (io/README 6): the bytes go into a new file beside the target,
// reach the disk, and then take the target's name in one step. Models, images, sessions and reports are all written
// this way.
//
//     SafeFile file(path);        // the folder must be there; the target is not touched yet
//     file.write(bytes);          // as often as needed
//     file.commit();              // synced, renamed
//
// Without commit() the destructor removes what was begun and the target stays as it was; what a killed process had
// begun goes when the same target is written again. A symbolic link is followed and stays a link; an existing file
// keeps its permissions, and is refused where they forbid writing; a target that is not a regular file (a pipe,
// /dev/stdout) is written directly. Other names of the target's file (hard links) keep what it held: see hasOtherNames.
// Errors are base::Error with the target's name. One thread at a time.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

class SafeFile {
  public:
    explicit SafeFile(const std::filesystem::path& target);
    ~SafeFile();
    SafeFile(const SafeFile&) = delete;
    SafeFile& operator=(const SafeFile&) = delete;

    void write(std::string_view bytes);
    /// After this the target holds all that was written. Nothing may be written any more.
    void commit();

  private:
    void refuseProtected() const;
    void openBeside();
    void discard() noexcept;
    [[noreturn]] void fail(const char* doing) const;

    std::filesystem::path m_target; ///< as the person named it
    std::filesystem::path m_final;  ///< links resolved
    std::string m_beside;           ///< the unfinished file; empty where the target is written directly
    int m_descriptor = -1;
};

/// Whether the file is known by other names too, which writing to it would leave with what it holds now.
bool hasOtherNames(const std::filesystem::path& target);

/// All of it at once.
void writeFile(const std::filesystem::path& target, std::string_view bytes);

} // namespace io
