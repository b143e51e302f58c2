#include "core/session/path_text.h"

#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>

namespace session {

static constexpr std::string_view scheme = "file://";

static bool isUtf8(const std::string& bytes) {
    try {
        static_cast<void>(nlohmann::json(bytes).dump());
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

std::string pathText(const std::string& bytes) {
    if (isUtf8(bytes))
        return bytes;
    constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/",
                               digits = "0123456789ABCDEF";
    std::string out(scheme);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (plain.find(c) != std::string_view::npos)
            out += c;
        else
            out.append({'%', digits[byte >> 4], digits[byte & 15]});
    }
    return out;
}

std::filesystem::path pathOf(const std::string& text) {
    if (!text.starts_with(scheme))
        return text;
    std::string out;
    for (std::size_t i = scheme.size(); i < text.size(); ++i) {
        unsigned char byte = 0;
        const char* from = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() && std::from_chars(from, from + 2, byte, 16).ptr == from + 2)
            out += static_cast<char>(byte), i += 2;
        else
            out += text[i];
    }
    return out;
}

} // namespace session
