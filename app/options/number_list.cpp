#include "app/options/number_list.h"

#include "core/io/number_text.h"

#include <charconv>

namespace app {

static const char* parse(const char* begin, const char* end, double& out) {
    return io::parseNumber(begin, end, out);
}

static const char* parse(const char* begin, const char* end, int& out) {
    if (end - begin > 1 && *begin == '+' && begin[1] != '-')
        ++begin;
    const auto [after, error] = std::from_chars(begin, end, out);
    return error == std::errc() ? after : nullptr;
}

template <class Number>
static bool parseAll(std::string_view text, char separator, std::span<Number> out) {
    const char *at = text.data(), *end = at + text.size();
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (i > 0 && (at == end || *at++ != separator))
            return false;
        while (at < end && (*at == ' ' || *at == '\t'))
            ++at;
        at = parse(at, end, out[i]);
        if (!at)
            return false;
    }
    return at == end;
}

bool parseNumbers(std::string_view text, char separator, std::span<double> out) {
    return parseAll(text, separator, out);
}

bool parseNumbers(std::string_view text, char separator, std::span<int> out) {
    return parseAll(text, separator, out);
}

} // namespace app
