// Text inside XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace app {

inline std::string escapedMarkup(std::string_view text) {
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

} // namespace app
