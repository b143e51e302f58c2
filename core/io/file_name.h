// What a file's name says about its format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace io {

/// ASCII letters only, whatever the locale.
inline std::string lowerCase(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
}

/// "ply" of "a.b.PLY"; empty where the name has none.
inline std::string extensionOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    return extension.empty() ? extension : extension.substr(1);
}

} // namespace io
