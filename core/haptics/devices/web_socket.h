// The client's side of a WebSocket (RFC 6455), as text in and text out of a line: handshake, frames in any pieces,
// answers to pings, messages of many frames. Knows no socket.
#pragma once

#include <functional>
#include <random>
#include <string>

namespace haptics {

/// What a server has to answer to a key.
std::string webSocketAccept(const std::string& key);

class WebSocket {
  public:
    /// Of a message, all its frames together; what is longer ends the line.
    static constexpr std::size_t mostMessage = 1 << 18;
    using Take = std::function<bool(const std::string& message)>;

    void begin(const std::string& host, std::string& out);
    /// Takes what is whole from the front of `in`, and calls `take` for each message. False where the other side breaks
    /// the rules, says goodbye, or `take` returns false.
    bool take(std::string& in, std::string& out, const Take& take);
    /// The handshake is done.
    bool open() const { return m_open; }
    void send(const std::string& message, std::string& out) { frame(1, message, out); }
    void end(std::string& out) { frame(8, {"\x03\xe8", 2}, out); } // 1000: done

  private:
    struct Frame {
        unsigned code;
        bool last;
        std::string body;
    };
    bool shake(std::string& in);
    bool hear(Frame frame, std::string& out, const Take& take);
    void frame(unsigned code, const std::string& body, std::string& out);

    std::random_device m_random; ///< masks only hide from what lies between what is sent
    std::string m_key, m_message;
    bool m_open = false, m_partial = false;
};

} // namespace haptics
