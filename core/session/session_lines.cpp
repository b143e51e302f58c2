#include "core/session/session_lines.h"

#include "core/base/error.h"
#include "core/io/waiting.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace session {

SessionLines::SessionLines(const std::filesystem::path& file) : m_name(file.string()), m_file(io::openToRead(file)) {
    if (m_file < 0 || std::filesystem::is_directory(file)) {
        if (m_file >= 0)
            ::close(m_file);
        throw base::Error("cannot be read", m_name, "name a session file");
    }
}

SessionLines::~SessionLines() {
    ::close(m_file);
}

bool SessionLines::fill() {
    if (m_at < m_block.size())
        return true;
    m_block.resize(std::size_t(1) << 16);
    m_at = 0;
    const ssize_t got = io::readSome(m_file, m_block.data(), m_block.size());
    m_block.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0)
        throw base::Error(std::string("cannot be read to its end (") + std::strerror(errno) + ")", m_name,
                          "the file or the pipe broke off; try again");
    return got > 0;
}

bool SessionLines::next() {
    text.clear();
    whole = false;
    if (!fill())
        return false;
    for (; !whole && fill(); m_at += whole ? 1 : 0) {
        const std::size_t end = m_block.find('\n', m_at), upTo = std::min(end, m_block.size());
        text.append(m_block, m_at, upTo - m_at);
        m_at = upTo;
        whole = end != std::string::npos;
        if (text.size() > longest)
            throw base::Error("has a line of more than " + std::to_string(longest >> 20) + " MiB and is no session",
                              m_name, "name a session file");
    }
    ++number;
    if (!text.empty() && text.back() == '\r')
        text.pop_back();
    return true;
}

bool SessionLines::isCommand() const {
    const std::size_t first = text.find_first_not_of(" \t");
    return first != std::string::npos && text[first] != '#';
}

} // namespace session
