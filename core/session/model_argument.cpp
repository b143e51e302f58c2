#include "core/session/model_argument.h"

#include "core/base/error.h"

#include <charconv>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static std::uint64_t numberOf(std::string_view text, const std::string& argument) {
    std::uint64_t out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc() || end != text.data() + text.size())
        throw base::Error("'" + std::string(text) + "' is not a number", argument, "write sample:NAME[:COUNT[:SEED]]");
    return out;
}

json modelCommand(const std::string& argument) {
    constexpr std::string_view prefix = "sample:";
    if (!argument.starts_with(prefix))
        return {{"op", "open"}, {"path", argument}};
    std::string_view rest = std::string_view(argument).substr(prefix.size());
    const auto next = [&rest] {
        const std::string_view word = rest.substr(0, rest.find(':'));
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
        return word;
    };
    json out{{"op", "new"}, {"sample", std::string(next())}};
    if (!rest.empty())
        out["count"] = numberOf(next(), argument);
    if (!rest.empty())
        out["seed"] = numberOf(rest, argument);
    return out;
}

} // namespace session
