// A line to a service on this machine or another, TCP or a Unix socket, on which nothing ever waits but `wait`.
//
// Addresses are "host:port" with a host in numbers or `localhost` (to look up a name may take seconds), or the path of
// a Unix socket. One thread at a time.
#pragma once

#include <string>

namespace haptics {

struct LineAddress {
    std::string host; ///< in numbers; empty: a Unix socket
    int port = 0;
    std::string path; ///< of a Unix socket
};
/// Throws base::Error for what is no address.
LineAddress lineAddress(const std::string& text);

class Line {
  public:
    Line() = default;
    ~Line() { close(); }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    /// Begins to connect. False where that fails at once.
    bool open(const LineAddress& address);
    void close();
    /// Whether it came to a connection; false while it is still on the way, and where `failed`.
    bool connected();
    bool failed() const { return m_file < 0; }
    /// Until something can be read or, where `writing`, written: at most so many milliseconds.
    void wait(int milliseconds, bool writing) const;
    /// Appends what has come, at most so many bytes. A line that has ended or broken is then closed.
    void read(std::string& into, std::size_t most);
    /// Sends what goes and takes it from the front.
    void write(std::string& out);

  private:
    int m_file = -1;
    bool m_connected = false;
};

} // namespace haptics
