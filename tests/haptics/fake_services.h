// The other side of a device's line, as the published protocols have it: what the services of an Inverse3, of VRPN and
// spacenavd send and understand.
#pragma once

#include "core/base/random.h"
#include "core/haptics/devices/inverse3.h"
#include "core/haptics/devices/space_mouse.h"
#include "core/haptics/devices/vrpn.h"
#include "core/haptics/devices/web_socket.h"

#include <arpa/inet.h>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <vector>

namespace haptics_test {

using base::Vec3d;
using nlohmann::json;

/// A listening socket and the one connection to it; each call waits two seconds at most.
class FakeService {
  public:
    /// At a port of its own, or at a path.
    explicit FakeService(const std::string& path = {}) {
        m_listening = ::socket(path.empty() ? AF_INET : AF_UNIX, SOCK_STREAM, 0);
        if (path.empty()) {
            sockaddr_in at{};
            at.sin_family = AF_INET;
            at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
            ::bind(m_listening, reinterpret_cast<sockaddr*>(&at), sizeof at);
            socklen_t size = sizeof at;
            ::getsockname(m_listening, reinterpret_cast<sockaddr*>(&at), &size);
            m_address = "127.0.0.1:" + std::to_string(ntohs(at.sin_port));
        } else {
            sockaddr_un at{};
            at.sun_family = AF_UNIX;
            std::strncpy(at.sun_path, path.c_str(), sizeof at.sun_path - 1);
            ::bind(m_listening, reinterpret_cast<sockaddr*>(&at), sizeof at);
            m_address = path;
        }
        ::listen(m_listening, 4);
    }
    ~FakeService() {
        drop();
        ::close(m_listening);
    }

    const std::string& address() const { return m_address; }
    bool accept() {
        if (!ready(m_listening, 2000))
            return false;
        m_line = ::accept(m_listening, nullptr, nullptr);
        return m_line >= 0;
    }
    void drop() {
        if (m_line >= 0)
            ::close(m_line);
        m_line = -1;
        heard.clear();
    }
    void say(const std::string& bytes) { ::send(m_line, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
    /// What has come is appended to `heard`; false where nothing comes in time, or the line has ended.
    bool hear(int milliseconds = 2000) {
        char part[4096];
        if (!ready(m_line, milliseconds))
            return false;
        const ssize_t got = ::recv(m_line, part, sizeof part, 0);
        if (got > 0)
            heard.append(part, static_cast<std::size_t>(got));
        return got > 0;
    }
    std::string heard;

  private:
    static bool ready(int file, int milliseconds) {
        pollfd at{file, POLLIN, 0};
        return ::poll(&at, 1, milliseconds) > 0;
    }
    int m_listening = -1, m_line = -1;
    std::string m_address;
};

/// @name Inverse3
/// @{
inline std::string serverFrame(const std::string& body, unsigned code = 1, bool last = true) {
    std::string out{static_cast<char>((last ? 0x80u : 0u) | code)};
    if (body.size() < 126) {
        out.push_back(static_cast<char>(body.size()));
    } else {
        out.push_back(126);
        out.push_back(static_cast<char>(body.size() >> 8));
        out.push_back(static_cast<char>(body.size()));
    }
    return out + body;
}

/// The answer to a client's handshake; empty where it is none.
inline std::string handshakeFor(const std::string& request) {
    const std::string name = "Sec-WebSocket-Key: ";
    const std::size_t at = request.find(name), end = request.find("\r\n", at);
    if (!request.starts_with("GET / HTTP/1.1\r\n") || at == std::string::npos ||
        request.find("Upgrade: websocket\r\n") == std::string::npos || !request.ends_with("\r\n\r\n"))
        return {};
    return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: " +
           haptics::webSocketAccept(request.substr(at + name.size(), end - at - name.size())) + "\r\n\r\n";
}

struct ClientFrame {
    unsigned code;
    std::string body;
};
/// The frames that are whole, taken from the front; each must be masked.
inline std::vector<ClientFrame> clientFrames(std::string& bytes) {
    std::vector<ClientFrame> out;
    while (bytes.size() >= 6) {
        std::size_t size = static_cast<unsigned char>(bytes[1]) & 127u, head = 2;
        if (size == 126) {
            size = static_cast<std::size_t>(static_cast<unsigned char>(bytes[2])) << 8 |
                   static_cast<unsigned char>(bytes[3]);
            head = 4;
        }
        if (bytes.size() < head + 4 + size)
            break;
        ClientFrame frame{static_cast<unsigned char>(bytes[0]) & 15u, bytes.substr(head + 4, size)};
        for (std::size_t i = 0; i < size; ++i)
            frame.body[i] = static_cast<char>(frame.body[i] ^ bytes[head + i % 4]);
        out.push_back((bytes[1] & 0x80) ? frame : ClientFrame{99, "not masked"});
        bytes.erase(0, head + 4 + size);
    }
    return out;
}

inline json xyz(const Vec3d& v) {
    return {{"x", v.x}, {"y", v.y}, {"z", v.z}};
}
/// In the device's frame.
inline std::string inverse3State(const Vec3d& place, const Vec3d& velocity, bool button = false) {
    return json{{"inverse3",
                 {{{"device_id", "04BA"},
                   {"config", {{"handedness", "right"}}},
                   {"state", {{"cursor_position", xyz(place)}, {"cursor_velocity", xyz(velocity)}}}}}},
                {"wireless_verse_grip",
                 {{{"device_id", "7"}, {"state", {{"buttons", {{"a", button}, {"b", false}, {"c", false}}}}}}}}}
        .dump();
}
/// The vector of a command; nothing where the text is none.
inline std::optional<Vec3d> forceIn(const std::string& text, const char* key = "vector") {
    try {
        const json all = json::parse(text), &device = all.at("inverse3").at(0);
        const json& v = device.at("commands").at("set_cursor_force").at(key);
        if (device.at("device_id") == "04BA")
            return Vec3d{v.at("x"), v.at("y"), v.at("z")};
    } catch (const json::exception&) {
    }
    return {};
}
/// @}

/// @name VRPN
/// @{
inline std::string bigEndian(std::uint64_t value, int bytes) {
    std::string out;
    for (int i = bytes - 1; i >= 0; --i)
        out.push_back(static_cast<char>(value >> (8 * i)));
    return out;
}
inline std::string real(double value) {
    return bigEndian(std::bit_cast<std::uint64_t>(value), 8);
}
inline std::string vrpnCookie(const char* version = "07.35") {
    std::string out = std::string("vrpn: ver. ") + version + "  0";
    out.resize(24, '\0');
    return out;
}
inline std::string vrpnMessage(int sender, int type, const std::string& body, double time = 0) {
    const auto whole = [](int value) { return bigEndian(static_cast<std::uint32_t>(value), 4); };
    const int seconds = static_cast<int>(time);
    std::string out = whole(static_cast<int>(24 + body.size())) + whole(seconds) +
                      whole(static_cast<int>((time - seconds) * 1e6)) + whole(sender) + whole(type) + whole(0) + body;
    out.resize((out.size() + 7) / 8 * 8, '\0');
    return out;
}
inline std::string vrpnName(int number, int what, const std::string& name) {
    return vrpnMessage(number, what, bigEndian(name.size() + 1, 4) + name + std::string(1, '\0'));
}
/// Device 3 is ours, 2 another.
inline std::string vrpnNames() {
    return vrpnName(2, -1, "Tracker9") + vrpnName(3, -1, "Phantom0") + vrpnName(5, -2, "vrpn_Tracker Pos_Quat") +
           vrpnName(6, -2, "vrpn_Button Change") + vrpnName(7, -2, "vrpn_Base ping_message");
}
inline std::string vrpnPlace(const Vec3d& at, double time, int sender = 3, int sensor = 0) {
    return vrpnMessage(sender, 5,
                       bigEndian(static_cast<std::uint32_t>(sensor), 4) + std::string(4, '\0') + real(at.x) +
                           real(at.y) + real(at.z) + real(0) + real(0) + real(0) + real(1),
                       time);
}
inline std::string vrpnButton(int button, bool down) {
    return vrpnMessage(3, 6, bigEndian(static_cast<std::uint32_t>(button), 4) + bigEndian(down ? 1 : 0, 4));
}
/// The forces of the fields in what a client says after its cookie, the last one last.
inline std::vector<Vec3d> vrpnForces(const std::string& said) {
    std::vector<Vec3d> out;
    const auto whole = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | static_cast<unsigned char>(said[at + i]);
        return value;
    };
    for (std::size_t at = 24; at + 24 <= said.size();) {
        const std::size_t size = whole(at);
        if (whole(at + 16) == 0 && size == 24 + 64 && at + size <= said.size()) {
            const auto number = [&](std::size_t k) {
                return static_cast<double>(std::bit_cast<float>(whole(at + 24 + 4 * k)));
            };
            out.push_back({number(3), number(4), number(5)});
        }
        at += (size + 7) / 8 * 8;
    }
    return out;
}
/// @}

inline std::string spaceEvent(std::initializer_list<std::int32_t> numbers) {
    std::int32_t all[8]{};
    std::copy(numbers.begin(), numbers.end(), all);
    return {reinterpret_cast<const char*>(all), sizeof all};
}

} // namespace haptics_test
