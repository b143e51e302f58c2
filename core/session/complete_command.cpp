// Checking and completing a command against its row.
#include "core/base/error.h"
#include "core/base/near_word.h"
#include "core/base/row_of_id.h"
#include "core/session/commands/commands.h"
#include "core/session/json_text.h"
#include "core/session/path_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace session {

using nlohmann::json;

namespace {

/// What a message says about one parameter: its name, quoted, and its command's.
std::string named(const CommandRow& row, const std::string& id) {
    return "\"" + id + "\" of \"" + row.op + "\"";
}

std::string number(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

std::string unitText(const CommandParameter& p) {
    return *p.unit ? std::string(" ") + p.unit : "";
}

std::string rangeText(const CommandParameter& p) {
    const std::string unit = unitText(p);
    const std::string low = p.min == positive ? "above 0" : "at least " + number(p.min);
    if (p.max >= largest)
        return low + unit;
    return p.min == positive ? low + " and at most " + number(p.max) + unit
                             : number(p.min) + " to " + number(p.max) + unit;
}

bool hasChoice(const CommandParameter& p, const std::string& value) {
    std::istringstream in(p.choices);
    for (std::string choice; in >> choice;)
        if (choice == value)
            return true;
    return false;
}

[[noreturn]] void refuse(const CommandRow& row, const CommandParameter& p, const json& value, const std::string& wish) {
    const std::string word = value.is_string() ? value.get<std::string>() : std::string();
    throw base::Error(named(row, p.id) + " is " + shortly(value) + " but must be " + wish, {},
                      base::didYouMean(word, p.choices));
}

void checkNumber(const CommandRow& row, const CommandParameter& p, const json& value) {
    const double x = value.get<double>();
    if (!std::isfinite(x) || x < p.min || x > p.max) // ranges do not name the largest number, which a value may exceed
        refuse(row, p, value, x > largest ? "at most " + number(p.max) + unitText(p) : rangeText(p));
}

/// One choice alone, several as a list: of a list, or of a text with commas.
json choicesOf(const CommandRow& row, const CommandParameter& p, const json& value) {
    json out = json::array();
    if (value.is_string()) {
        std::istringstream in(value.get<std::string>());
        for (std::string choice; std::getline(in, choice, ',');)
            out.push_back(choice);
    } else if (value.is_array()) {
        out = value;
    }
    const auto known = [&](const json& each) { return each.is_string() && hasChoice(p, each.get<std::string>()); };
    if (out.empty() || !std::all_of(out.begin(), out.end(), known))
        refuse(row, p, value, "one or several of " + std::string(p.choices));
    return out.size() == 1 ? out[0] : out;
}

bool isRange(const json& value) {
    const auto whole = [](const json& v) { return v.is_number_unsigned(); };
    return whole(value) || (value.is_array() && value.size() == 2 && whole(value[0]) && whole(value[1]));
}

json absolutePath(const json& value, const std::filesystem::path& folder) {
    return std::filesystem::absolute(folder / pathOf(value.get<std::string>())).lexically_normal().string();
}

bool isText(const json& value) {
    return value.is_string() && !value.get_ref<const std::string&>().empty();
}

/// Several numbers in one text, "0,1,0,0.25", may come as a list, too, as places and planes do elsewhere.
json asText(const json& value) {
    if (!value.is_array() || !std::all_of(value.begin(), value.end(), [](const json& v) { return v.is_number(); }))
        return value;
    std::string out;
    for (const json& each : value)
        out += (out.empty() ? "" : ",") + each.dump();
    return out;
}

/// The value in the form that commands read.
json checked(const CommandRow& row, const CommandParameter& p, const json& value, const std::filesystem::path& folder) {
    const std::string_view type = p.type;
    const bool choice = type == "choice" || type == "number or choice";
    if (choice && value.is_string() && hasChoice(p, value.get<std::string>()))
        return value;
    if (type == "number" || (type == "number or choice" && value.is_number())) {
        if (!value.is_number())
            refuse(row, p, value, "a number, " + rangeText(p));
        checkNumber(row, p, value);
    } else if (type == "integer") {
        if (!value.is_number_integer())
            refuse(row, p, value, "a whole number, " + rangeText(p));
        checkNumber(row, p, value);
    } else if (choice) {
        std::string wish = "one of " + std::string(p.choices);
        refuse(row, p, value, type == "choice" ? wish : "a number, " + rangeText(p) + ", or " + wish);
    } else if (type == "boolean") {
        if (value == "on" || value == "off")
            return value == "on";
        if (!value.is_boolean())
            refuse(row, p, value, "true or false, or one of on off");
    } else if (type == "list") {
        if (!value.is_array())
            refuse(row, p, value, "a list");
    } else if (type == "choices") {
        return choicesOf(row, p, value);
    } else if (type == "range") {
        if (!isRange(value))
            refuse(row, p, value, "a whole number or a list of the least and the greatest");
    } else if (type == "paths") { // one of them may stand alone
        json out = value.is_array() ? value : json::array({value});
        if (out.empty() || !std::all_of(out.begin(), out.end(), isText))
            refuse(row, p, value, "a list of paths");
        for (json& each : out)
            each = absolutePath(each, folder);
        return out;
    } else { // path, text
        const json text = type == "text" ? asText(value) : value;
        if (!isText(text))
            refuse(row, p, value, text == "" ? "text that is not empty" : "text in quotation marks");
        return type == "path" ? absolutePath(text, folder) : text;
    }
    return value;
}

[[noreturn]] void refuseUnknown(const CommandRow& row, const std::string& id) {
    const std::string known = base::joinedIds(row.parameters);
    throw base::Error("unknown parameter " + named(row, id), {},
                      base::didYouMeanOr(id, known, known.empty() ? "it takes none" : "it takes " + known));
}

} // namespace

json checked(const CommandRow& row, const std::string& id, const json& value) {
    const CommandParameter* p = base::findRow(row.parameters, id);
    return p ? checked(row, *p, value, {}) : throw base::Error("unknown parameter " + named(row, id));
}

json complete(const json& given, const std::filesystem::path& folder) {
    if (!given.is_object() || !given.contains("op") || !given["op"].is_string())
        throw base::Error("not a command", {}, R"(a command is an object with a name: {"op":"undo"})");
    const CommandRow& row = command(given["op"].get_ref<const std::string&>());
    json out{{"op", row.op}};
    for (const CommandParameter& p : row.parameters) {
        if (given.contains(p.id) && !given[p.id].is_null())
            out[p.id] = checked(row, p, given[p.id], folder);
        else if (!*p.fallback)
            throw base::Error("\"" + std::string(row.op) + "\" needs the parameter \"" + p.id + "\"", {}, p.tip);
        else if (std::string_view(p.fallback) != "null")
            out[p.id] = json::parse(p.fallback);
    }
    for (const auto& [key, value] : given.items()) {
        if (key == "op" || base::findRow(row.parameters, key))
            continue;
        if (!row.checkFurther)
            refuseUnknown(row, key);
        row.checkFurther(out, key, value);
        out[key] = value;
    }
    return out;
}

} // namespace session
