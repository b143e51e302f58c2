#include "core/haptics/devices/web_socket.h"

#include <algorithm>
#include <cstdint>

namespace haptics {

std::string base64(const std::string& bytes);

/// Of the server's answer to the handshake.
constexpr std::size_t mostHeader = 8192;

void WebSocket::begin(const std::string& host, std::string& out) {
    std::string nonce;
    for (int i = 0; i < 16; ++i)
        nonce.push_back(static_cast<char>(m_random()));
    m_key = base64(nonce);
    out += "GET / HTTP/1.1\r\nHost: " + host +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " + m_key +
           "\r\nSec-WebSocket-Version: 13\r\n\r\n";
}

void WebSocket::frame(unsigned code, const std::string& body, std::string& out) {
    out.push_back(static_cast<char>(0x80 | code));
    const std::size_t size = body.size();
    const int extended = size < 126 ? 0 : size < 65536 ? 2 : 8;
    out.push_back(static_cast<char>(0x80 | (extended == 0 ? size : extended == 2 ? 126u : 127u)));
    for (int i = extended - 1; i >= 0; --i)
        out.push_back(static_cast<char>(static_cast<std::uint64_t>(size) >> (8 * i)));
    const unsigned random = m_random();
    for (int i = 0; i < 4; ++i)
        out.push_back(static_cast<char>(random >> (8 * i)));
    for (std::size_t i = 0; i < size; ++i)
        out.push_back(static_cast<char>(static_cast<unsigned char>(body[i]) ^ (random >> (8 * (i % 4)) & 255)));
}

static std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The value of a header's line; empty where there is none.
static std::string valueOf(const std::string& header, const std::string& name) {
    const std::string low = lowered(header);
    const std::size_t at = low.find("\r\n" + name + ":");
    if (at == std::string::npos)
        return {};
    const std::size_t begin = header.find_first_not_of(' ', at + name.size() + 3), end = header.find("\r\n", begin);
    return begin < end ? header.substr(begin, header.find_last_not_of(" \t", end - 1) + 1 - begin) : std::string();
}

/// Tells whether the line may go on: the server's answer is right, or has not wholly come.
bool WebSocket::shake(std::string& in) {
    const std::size_t end = in.find("\r\n\r\n");
    if (end == std::string::npos)
        return in.size() <= mostHeader;
    if (end > mostHeader)
        return false;
    const std::string header = in.substr(0, end + 2);
    in.erase(0, end + 4);
    m_open = header.starts_with("HTTP/1.1 101") && valueOf(header, "sec-websocket-accept") == webSocketAccept(m_key);
    return m_open;
}

bool WebSocket::take(std::string& in, std::string& out, const Take& take) {
    if (!m_open && !shake(in))
        return false;
    if (!m_open)
        return true;
    std::size_t at = 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(in[at + i]); };
    for (;;) {
        const std::size_t had = in.size() - at;
        if (had < 2)
            break;
        const unsigned code = byte(0) & 15u, small = byte(1) & 127u;
        const bool last = byte(0) & 0x80, control = code >= 8;
        if ((byte(0) & 0x70) || (byte(1) & 0x80) || (control && (small > 125 || !last)))
            return false;
        const std::size_t head = 2 + (small == 126 ? 2u : small == 127 ? 8u : 0u);
        if (had < head)
            break;
        std::uint64_t size = small < 126 ? small : 0;
        for (std::size_t i = 2; i < head; ++i)
            size = size << 8 | byte(i);
        if (size > mostMessage)
            return false;
        if (had < head + size)
            break;
        Frame frame{code, last, in.substr(at + head, size)};
        at += head + size;
        if (!hear(std::move(frame), out, take))
            return false;
    }
    in.erase(0, at);
    return true;
}

bool WebSocket::hear(Frame frame, std::string& out, const Take& take) {
    switch (frame.code) {
    case 0: // goes on
        if (!m_partial)
            return false;
        break;
    case 1: // text
    case 2: // bytes
        if (m_partial)
            return false;
        m_message.clear();
        break;
    case 9: // ping
        this->frame(10, frame.body, out);
        return true;
    case 10: // pong
        return true;
    default: // goodbye, and what there is not
        return false;
    }
    if (m_message.size() + frame.body.size() > mostMessage)
        return false;
    m_message += frame.body;
    m_partial = !frame.last;
    return m_partial || take(m_message);
}

} // namespace haptics
