#include "core/session/json_text.h"

#include "core/base/error.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static const char* const anExample = R"(a line is an object such as {"op":"undo"})";

/// How deep brackets are nested; those in texts do not count.
static int depthOf(std::string_view text) {
    int depth = 0, deepest = 0;
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inside) {
            i += c == '\\' ? 1 : 0;
            inside = c != '"';
        } else if (c == '"') {
            inside = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return deepest;
}

/// What stands between the quotation marks of the library's message, shortly.
static std::string quotedIn(const std::string& message) {
    const std::size_t first = message.find('\'');
    std::string out = first == std::string::npos ? "" : message.substr(first + 1, message.rfind('\'') - first - 1);
    return out.size() > 40 ? out.substr(0, 37) + "..." : out;
}

json jsonOf(std::string_view text) {
    if (depthOf(text) > deepestJson)
        throw base::Error("the JSON is nested more than " + std::to_string(deepestJson) + " levels deep", {},
                          anExample);
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        if (error.byte > text.size())
            throw base::Error("the JSON breaks off", {}, "the text was cut off; write it again as a whole");
        throw base::Error("not JSON from character " + std::to_string(error.byte) + " on", {}, anExample);
    } catch (const json::out_of_range& error) {
        throw base::Error("the number " + quotedIn(error.what()) + " is beyond the largest, 1.8e308", {},
                          "correct the number");
    }
}

std::string shortly(const json& value, std::size_t most) {
    const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    return text.size() > most ? text.substr(0, most - 3) + "..." : text;
}

} // namespace session
