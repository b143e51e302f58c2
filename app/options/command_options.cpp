#include "app/options/command_options.h"

#include "core/base/error.h"
#include "core/io/number_text.h"
#include "core/session/number_text_list.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace app {

using nlohmann::json;

/// "0,0,9" as a list of numbers, "0,0 10,5" as a list of such: what a shell passes on as one word, or two in quotes.
/// Text that is no list of numbers stays, for the session's check to refuse.
static std::string listOf(const std::string& text) {
    json groups = json::array();
    std::istringstream in(text);
    for (std::string group; in >> group;) {
        json numbers = json::array();
        std::istringstream parts(group);
        for (std::string part; std::getline(parts, part, ',');) {
            const auto number = io::numberOf(part);
            if (!number || !std::isfinite(*number))
                return text;
            numbers.push_back(*number);
        }
        groups.push_back(numbers);
    }
    return groups.size() == 1 ? groups[0].dump() : groups.dump();
}

static std::string valueText(const session::CommandParameter& parameter, const std::string& text) {
    return parameter.type == std::string_view("list") ? listOf(text) : text;
}

/// A number or a list where the text is one, else the text: what the session's check wants to see.
static json valueOf(const std::string& text) {
    if (text.starts_with('['))
        if (const json list = json::parse(text, nullptr, false); list.is_array())
            return list;
    if (const auto count = io::countOf(text))
        return *count;
    const auto number = io::numberOf(text);
    return number && std::isfinite(*number) ? json(*number) : json(text);
}

bool has(const GivenParameters& given, const std::string& name) {
    return std::any_of(given.begin(), given.end(), [&](const auto& each) { return each.first == name; });
}

json parametersOf(const GivenParameters& given) {
    json out = json::object();
    for (const auto& [name, value] : given)
        out[name] = valueOf(value);
    return out;
}

/// Several numbers in one text, which commands read when they run: after a model was opened.
static void requireNumbers(const std::string& id, const std::string& value) {
    if (id == "position" || id == "rotation")
        session::vectorOf(value, id);
}

/// Something that passes the check.
static json standIn(const session::CommandParameter& p) {
    const std::string_view type = p.type;
    if (type == "number" || type == "integer")
        return std::clamp(1.0, p.min, p.max);
    return type == "list" ? json::array({0}) : json("-");
}

/// The session's own check of one value: "" where it is all right.
static std::string fault(const std::string& op, const std::string& id, const std::string& value) {
    try {
        requireNumbers(id, value);
        json command{{"op", op}, {id, valueOf(value)}};
        for (const session::CommandParameter& p : session::command(op).parameters)
            if (!*p.fallback && id != p.id)
                command[p.id] = standIn(p); // required, and not what is asked about
        session::complete(command);
        return {};
    } catch (const base::Error& error) {
        const std::string named = "\"" + id + "\" of \"" + op + "\"", text = error.message();
        return text.starts_with(named) ? "the value" + text.substr(named.size()) : text;
    }
}

/// A tip that begins with how a session writes the list, "[x,y,z] that" or "[[x,y],...], a lasso": how a shell does,
/// x,y,z or 'x,y x,y ...', and the rest. Both are empty of other tips.
static std::pair<std::string, std::string> listHelp(const std::string& help) {
    const bool nested = help.starts_with("[[") && help.find("...]") != std::string::npos;
    const std::size_t end = help.find(']'), rest = nested ? help.find("...]") + 4 : end + 1;
    if (!help.starts_with('[') || end == std::string::npos || rest > help.size())
        return {};
    const std::string each = help.substr(nested ? 2 : 1, end - (nested ? 2 : 1));
    return {nested ? "'" + each + " " + each + " ...'" : each,
            help.substr(std::min(help.find_first_not_of(", ", rest), help.size()))};
}

Option addParameter(OptionSet command, const std::string& op, const session::CommandParameter& parameter,
                    const std::string& help, GivenParameters& given) {
    const std::string id = parameter.id;
    std::string name = "--" + id;
    const auto [written, meaning] = parameter.type == std::string_view("list") ? listHelp(help) : listHelp({});
    std::replace(name.begin(), name.end(), '_', '-');
    Option option = command.addTo(
        name,
        [&given, &parameter, id](const std::string& value) { given.emplace_back(id, valueText(parameter, value)); },
        meaning.empty() ? help : meaning);
    if (!written.empty())
        option.typeName(written);
    return option.check(
        {[op, id, &parameter](const std::string& value) { return fault(op, id, valueText(parameter, value)); }});
}

/// What holds where nothing is given, as it would be written; "" where that is nothing.
static std::string fallbackOf(const session::CommandParameter& p) {
    if (!*p.fallback)
        return {};
    const json value = json::parse(p.fallback);
    if (p.type == std::string_view("choices")) {
        std::string out;
        for (const json& each : value)
            out += (out.empty() ? "" : ",") + each.get<std::string>();
        return out;
    }
    if (value.is_boolean())
        return value.get<bool>() ? "on" : "off";
    return value.is_null() ? std::string() : value.is_string() ? value.get<std::string>() : value.dump();
}

std::string helpOf(const session::CommandParameter& p) {
    const std::string_view type = p.type;
    std::string choices = type == "boolean" ? "on off" : p.choices;
    std::replace(choices.begin(), choices.end(), ' ', '|');
    std::string out = p.tip;
    if (*p.unit)
        out += std::string(", in ") + p.unit;
    if (!choices.empty())
        out += ": " + (type == "number or choice" ? "NUMBER|" + choices : choices);
    if (type == "choices")
        out += ", or several with commas";
    if (const std::string fallback = fallbackOf(p); !fallback.empty())
        out += " [" + fallback + "]";
    return out;
}

} // namespace app
