#include "core/io/number_text.h"

#include <charconv>
#include <cstring>
#include <limits>
#include <string>

namespace io {

static bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether the out-of-range number in the text, without sign, is too large rather than too small.
static bool tooLarge(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, e);
    if (e != std::string_view::npos && e + 1 < text.size()) {
        if (mantissa.size() < 300) // the exponent decides
            return text[e + 1] != '-';
    }
    const std::size_t first = mantissa.find_first_of("123456789");
    return first != std::string_view::npos && first < mantissa.find('.');
}

/// 1.#INF, 1.#QNAN, 1.#IND and the like: what stands after "1." tells.
static const char* parseOldWindows(const char* hash, const char* end, double& out) {
    out = end - hash >= 4 && std::memcmp(hash, "#INF", 4) == 0 ? std::numeric_limits<double>::infinity()
                                                               : std::numeric_limits<double>::quiet_NaN();
    while (hash < end && (*hash == '#' || (*hash >= 'A' && *hash <= 'Z') || isDigit(*hash)))
        ++hash;
    return hash;
}

/// Whether an exponent as Fortran writes it begins at the 'D': D+00, d-3, D12.
static bool isFortranExponent(const char* at, const char* end) {
    if (at == end || (*at != 'D' && *at != 'd'))
        return false;
    ++at;
    at += at < end && (*at == '+' || *at == '-') ? 1 : 0;
    return at < end && isDigit(*at);
}

/// The number whose exponent begins at `letter`, read with an e in its place.
static const char* parseFortran(const char* begin, const char* letter, const char* end, double& out) {
    const char* last = letter + 2;
    while (last < end && isDigit(*last))
        ++last;
    std::string text(begin, last);
    text[static_cast<std::size_t>(letter - begin)] = 'e';
    return parseNumber(text.data(), text.data() + text.size(), out) ? last : nullptr;
}

const char* parseNumber(const char* begin, const char* end, double& out) {
    if (begin < end && *begin == '+') {
        ++begin;
        if (begin < end && *begin == '-')
            return nullptr;
    }
    const auto [after, code] = std::from_chars(begin, end, out);
    if (code == std::errc::invalid_argument)
        return nullptr;
    if (isFortranExponent(after, end))
        return parseFortran(begin, after, end, out);
    const bool negative = *begin == '-';
    if (code == std::errc::result_out_of_range) {
        const char* digits = begin + (negative ? 1 : 0);
        out = tooLarge({digits, after}) ? std::numeric_limits<double>::infinity() : 0.0;
        out = negative ? -out : out;
    } else if (after < end && *after == '#') {
        const char* rest = parseOldWindows(after, end, out);
        out = negative ? -out : out;
        return rest;
    }
    return after;
}

std::optional<double> numberOf(std::string_view text) {
    double value = 0;
    const char* end = text.data() + text.size();
    if (text.empty() || parseNumber(text.data(), end, value) != end)
        return {};
    return value;
}

std::optional<std::uint64_t> countOf(std::string_view text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [after, code] = std::from_chars(text.data(), end, value);
    if (text.empty() || code != std::errc() || after != end)
        return {};
    return value;
}

template <class T>
static void append(std::string& out, T value) {
    char buffer[40];
    const auto [end, code] = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, end);
    static_cast<void>(code); // 40 characters hold every one of them
}

void appendNumber(std::string& out, float value) {
    append(out, value);
}
void appendNumber(std::string& out, double value) {
    append(out, value);
}
void appendNumber(std::string& out, std::int64_t value) {
    append(out, value);
}

} // namespace io
