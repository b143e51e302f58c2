// The lines of a session, from a file or from a pipe as they come, with a look at what follows, so that the last one is
// known. Inside this room only.
//
// A signal that interrupts the wait for a pipe is noticed (base::CancelScope). A line of more than `longest` is no
// command: devices go on without a newline. Throws base::Error, base::Cancelled. One thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace session {

class SessionLines {
  public:
    explicit SessionLines(const std::filesystem::path& file);
    ~SessionLines();
    SessionLines(const SessionLines&) = delete;
    SessionLines& operator=(const SessionLines&) = delete;

    static constexpr std::size_t longest = std::size_t(1) << 29;

    /// Goes to the next line; false behind the last one.
    bool next();
    /// Nothing follows. Waits until that is known.
    bool isLast() { return !fill(); }
    /// Neither empty nor a comment.
    bool isCommand() const;

    std::string text;  ///< without its end
    int number = 0;    ///< counted from 1
    bool whole = true; ///< ended by a newline

  private:
    /// Whether there is a byte at m_at, read where there is none yet.
    bool fill();

    std::string m_name;
    int m_file = -1;
    std::string m_block; ///< what was read last
    std::size_t m_at = 0;
};

} // namespace session
