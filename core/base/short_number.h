// Numbers in sentences: six significant digits unless told, as printf's %g writes them, but with a decimal point in
// every locale.
#pragma once

#include <charconv>
#include <string>

namespace base {

inline std::string shortNumber(double value, int digits = 6) {
    char out[32];
    return {out, std::to_chars(out, out + sizeof out, value, std::chars_format::general, digits).ptr};
}

} // namespace base
