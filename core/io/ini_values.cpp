#include "core/io/ini_values.h"

#include <charconv>

namespace io {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    return begin == text.npos ? std::string_view() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

void appendUtf8(std::string& out, unsigned code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | code >> 6);
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xe0 | (code >> 12 & 0xf));
        out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

/// The number after \x or \ in octal; at most what 16 bits hold, as QSettings writes it.
const char* appendCode(std::string& out, const char* at, const char* end, int base) {
    unsigned code = 0;
    const auto [after, error] = std::from_chars(at, end, code, base);
    if (error == std::errc())
        appendUtf8(out, code & 0xffff);
    return after;
}

/// `at` stands behind a backslash.
const char* appendEscaped(std::string& out, const char* at, const char* end) {
    constexpr std::string_view names = "abfnrtv\"?'\\", meant = "\a\b\f\n\r\t\v\"?'\\";
    if (at == end)
        return at;
    if (const std::size_t k = names.find(*at); k != names.npos) {
        out += meant[k];
        return at + 1;
    }
    if (*at == 'x')
        return appendCode(out, at + 1, end, 16);
    return *at >= '0' && *at <= '7' ? appendCode(out, at, end, 8) : at + 1;
}

std::vector<std::string> valuesOf(std::string_view text) {
    std::vector<std::string> out(1);
    std::size_t kept = 0; // of the last value: what no blank at its end may take away
    bool quoted = false;
    const auto close = [&] { out.back().resize(std::max(kept, out.back().find_last_not_of(blanks) + 1)); };
    const char *at = text.data(), *end = at + text.size();
    while (at < end) {
        const char c = *at++;
        if (c == '\\') {
            at = appendEscaped(out.back(), at, end);
            kept = out.back().size();
        } else if (c == '"') {
            quoted = !quoted;
            kept = out.back().size();
        } else if (c == ',' && !quoted) {
            close();
            out.emplace_back();
            kept = 0;
        } else if (quoted || !out.back().empty() || blanks.find(c) == blanks.npos) {
            out.back() += c;
        }
    }
    close();
    return out;
}

} // namespace

std::optional<std::vector<std::string>> iniValues(std::string_view file, std::string_view section,
                                                  std::string_view key) {
    bool inside = false;
    while (!file.empty()) {
        const std::string_view line = trimmed(file.substr(0, file.find('\n')));
        file.remove_prefix(std::min(file.size(), file.find('\n') == file.npos ? file.size() : file.find('\n') + 1));
        const std::size_t equals = line.find('=');
        if (line.starts_with('[') && line.ends_with(']'))
            inside = line.substr(1, line.size() - 2) == section;
        else if (inside && equals != line.npos && trimmed(line.substr(0, equals)) == key)
            return valuesOf(trimmed(line.substr(equals + 1)));
    }
    return {};
}

} // namespace io
