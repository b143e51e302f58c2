#include "core/io/obj/obj_statements.h"

#include "core/io/number_text.h"

#include <charconv>

namespace io {

Statement takeStatement(std::string_view& line) {
    skipBlanks(line);
    const auto follows = [&](std::string_view word) {
        return line.starts_with(word) && line.size() > word.size() && isBlank(line[word.size()]);
    };
    static constexpr std::pair<std::string_view, Statement> words[] = {
        {"v", Statement::Vertex},   {"f", Statement::Face},          {"vn", Statement::Normal},
        {"vt", Statement::Texture}, {"usemtl", Statement::Material}, {"mtllib", Statement::Library}};
    for (const auto& [word, statement] : words)
        if (follows(word)) {
            line.remove_prefix(word.size());
            return statement;
        }
    return Statement::Other;
}

std::size_t takeNumbers(std::string_view line, double* out, std::size_t most) {
    std::size_t n = 0;
    for (skipBlanks(line); n < most && !line.empty() && line.front() != '#'; skipBlanks(line)) {
        const char* after = parseNumber(line.data(), line.data() + line.size(), out[n]);
        if (!after)
            break;
        line.remove_prefix(static_cast<std::size_t>(after - line.data()));
        ++n;
    }
    return n;
}

bool takeIndex(std::string_view text, std::size_t sofar, std::size_t total, std::uint32_t& to) {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    value += value < 0 ? static_cast<std::int64_t>(sofar) : -1;
    to = static_cast<std::uint32_t>(value);
    return code == std::errc() && value >= 0 && value < static_cast<std::int64_t>(total);
}

std::string joinedLines(std::string_view text) {
    std::string out;
    for (std::size_t at = text.find('\\'); at != std::string_view::npos; at = text.find('\\', at + 1)) {
        const std::size_t end = at + (text.substr(at + 1, 1) == "\r" ? 2 : 1);
        if (end >= text.size() || text[end] != '\n')
            continue;
        if (out.empty())
            out = text;
        std::fill(out.begin() + static_cast<std::ptrdiff_t>(at), out.begin() + static_cast<std::ptrdiff_t>(end + 1),
                  ' ');
    }
    return out;
}

} // namespace io
