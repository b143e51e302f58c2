#include "core/io/text/text_lines.h"

#include <cstring>

namespace io {

TextLines::TextLines(const FileBytes& file, std::size_t begin) : m_file(file), m_begin(begin) {
    if (!std::memchr(text().data() + begin, '\n', text().size() - begin))
        m_end = '\r';
    // A chunk owns the lines that start in its megabyte. One that is inside a long line owns none.
    m_starts = {begin};
    for (std::size_t cut = begin + chunkBytes; cut < text().size(); cut += chunkBytes)
        m_starts.push_back(m_starts.back() >= cut ? m_starts.back() : nextLine(cut - 1));
    m_starts.push_back(text().size());
}

std::string_view TextLines::lineAt(std::size_t offset) const {
    const std::string_view rest = text().substr(offset);
    const auto* end = static_cast<const char*>(std::memchr(rest.data(), m_end, rest.size()));
    return end ? rest.substr(0, static_cast<std::size_t>(end - rest.data())) : rest;
}

std::size_t TextLines::nextLine(std::size_t offset) const {
    return std::min(offset + lineAt(offset).size() + 1, text().size());
}

} // namespace io
