#include "core/haptics/devices/line.h"

#include "core/base/error.h"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace haptics {

LineAddress lineAddress(const std::string& text) {
    LineAddress out;
    if (text.starts_with('/')) {
        if (text.size() >= sizeof(sockaddr_un::sun_path))
            throw base::Error("the path of a socket is too long", text);
        out.path = text;
        return out;
    }
    const std::size_t colon = text.rfind(':');
    out.host = text.substr(0, colon);
    if (out.host == "localhost")
        out.host = "127.0.0.1";
    in_addr numbers{};
    const char *first = text.data() + (colon == std::string::npos ? text.size() : colon + 1),
               *last = text.data() + text.size();
    const auto [end, error] = std::from_chars(first, last, out.port);
    const bool port = error == std::errc() && end == last && out.port > 0 && out.port < 65536;
    if (!port || inet_pton(AF_INET, out.host.c_str(), &numbers) != 1)
        throw base::Error("'" + text + "' is no address of a device", "",
                          "give it as localhost:PORT, 192.168.0.5:PORT or the path of a socket");
    return out;
}

static int openSocket(int family) {
    const int file = ::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;
    if (file >= 0 && family == AF_INET)
        ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return file;
}

bool Line::open(const LineAddress& address) {
    close();
    int said = -1;
    if (address.host.empty()) {
        sockaddr_un to{};
        to.sun_family = AF_UNIX;
        std::memcpy(to.sun_path, address.path.c_str(), std::min(address.path.size() + 1, sizeof to.sun_path - 1));
        m_file = openSocket(AF_UNIX);
        said = m_file < 0 ? -1 : ::connect(m_file, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    } else {
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(static_cast<std::uint16_t>(address.port));
        inet_pton(AF_INET, address.host.c_str(), &to.sin_addr);
        m_file = openSocket(AF_INET);
        said = m_file < 0 ? -1 : ::connect(m_file, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    }
    m_connected = said == 0;
    if (said != 0 && errno != EINPROGRESS)
        close();
    return !failed();
}

void Line::close() {
    if (m_file >= 0)
        ::close(m_file);
    m_file = -1;
    m_connected = false;
}

bool Line::connected() {
    if (m_connected || failed())
        return m_connected;
    pollfd at{m_file, POLLOUT, 0};
    if (::poll(&at, 1, 0) <= 0)
        return false;
    int error = 0;
    socklen_t size = sizeof error;
    if (::getsockopt(m_file, SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0)
        close();
    else
        m_connected = true;
    return m_connected;
}

void Line::wait(int milliseconds, bool writing) const {
    pollfd at{m_file, static_cast<short>(POLLIN | (writing ? POLLOUT : 0)), 0};
    ::poll(&at, 1, milliseconds); // of a closed line: the time alone
}

void Line::read(std::string& into, std::size_t most) {
    char part[4096];
    for (std::size_t had = into.size(); !failed() && into.size() - had < most;) {
        const ssize_t got = ::recv(m_file, part, std::min(sizeof part, most - (into.size() - had)), 0);
        if (got > 0)
            into.append(part, static_cast<std::size_t>(got));
        else if (got < 0 && errno == EINTR)
            continue;
        else if (got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK))
            close();
        else
            return;
    }
}

void Line::write(std::string& out) {
    while (!failed() && !out.empty()) {
        const ssize_t sent = ::send(m_file, out.data(), out.size(), MSG_NOSIGNAL);
        if (sent > 0)
            out.erase(0, static_cast<std::size_t>(sent));
        else if (sent < 0 && errno == EINTR)
            continue;
        else if (sent < 0 && errno != EAGAIN && errno != EWOULDBLOCK)
            close();
        else
            return;
    }
}

} // namespace haptics
