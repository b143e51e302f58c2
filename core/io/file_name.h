// What a file's name says about its format.
#pragma once

#include <filesystem>
#include <iterator>
#include <sstream>
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

/// Is the extension among a format's, which blanks separate?
inline bool isAmong(std::string_view extension, std::string_view extensions) {
    std::istringstream words{std::string(extensions)};
    for (std::string word; words >> word;)
        if (word == extension)
            return true;
    return false;
}

/// Of a table of formats, the row that has the extension; null where none has.
template <class Rows>
auto rowOfExtension(const Rows& rows, std::string_view extension) -> decltype(std::data(rows)) {
    for (const auto& row : rows)
        if (isAmong(extension, row.extensions))
            return &row;
    return nullptr;
}

} // namespace io
