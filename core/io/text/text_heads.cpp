#include "core/io/text/text_heads.h"

#include "core/io/file_name.h"
#include "core/io/number_text.h"

#include <algorithm>

namespace io {

std::vector<std::string> namesIn(std::string_view line, const std::vector<std::string_view>& fields) {
    if (line.find_first_of(",;") == std::string_view::npos)
        return {fields.begin(), fields.end()};
    std::vector<std::string> names;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t end = std::min(line.find_first_of(",;", at), line.size());
        std::string_view name = line.substr(at, end - at);
        const std::size_t first = name.find_first_not_of(" \t\r\""), last = name.find_last_not_of(" \t\r\"");
        names.emplace_back(first == std::string_view::npos ? "" : name.substr(first, last - first + 1));
        at = end + 1;
    }
    return names;
}

std::vector<std::string> commentNames(std::string_view text) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const std::size_t marks = line.find_first_not_of("#/% \t");
    if (marks == 0 || marks == std::string_view::npos)
        return {};
    std::vector<std::string> names;
    for (std::string_view rest = line.substr(marks); !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(" ,;\t"), rest.size());
        if (end > 0)
            names.push_back(lowerCase(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    for (const char* wanted : {"x", "y", "z"})
        if (std::find(names.begin(), names.end(), wanted) == names.end())
            return {};
    return names;
}

bool isPoint(const std::vector<std::string_view>& fields, bool named) {
    const auto numbers = std::count_if(fields.begin(), fields.end(), [](std::string_view f) { return numberOf(f); });
    return numbers > 0 && (numberOf(fields[0]) || (named && numbers >= 3));
}

} // namespace io
