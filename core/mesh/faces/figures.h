// Numbers as they stand in sentences.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>

namespace mesh {

/// "12", "1,234,567".
inline std::string grouped(std::size_t n) {
    std::string out = std::to_string(n);
    for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(out.size()) - 3; at > 0; at -= 3)
        out.insert(static_cast<std::size_t>(at), ",");
    return out;
}

inline std::string rounded(double value) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr};
}

inline std::string counted(std::size_t n, const char* one, const char* many) {
    return grouped(n) + " " + (n == 1 ? one : many);
}

} // namespace mesh
