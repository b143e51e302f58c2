#include "core/session/option_json.h"

#include "core/base/error.h"
#include "core/session/commands/commands.h"
#include "core/session/json_text.h"

#include <cctype>
#include <charconv>
#include <deque>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;
using sculpt::Axis;
using sculpt::CurvePoints;
using sculpt::MirrorPlanes;
using sculpt::StrokeOption;
using sculpt::StrokeSettings;

// --- kinds of fields ---

static const char* typeOf(float) {
    return "number";
}
static const char* typeOf(int) {
    return "integer";
}
static const char* typeOf(bool) {
    return "boolean";
}
static const char* typeOf(const std::string&) {
    return "path";
}
static const char* typeOf(const CurvePoints&) {
    return "list";
}
static const char* typeOf(const MirrorPlanes&) {
    return "list";
}
template <class Choice>
static const char* typeOf(Choice) {
    return "choice";
}

static json encoded(const StrokeOption& option, float value) {
    return sculpt::shownOf(option, value);
}
static json encoded(const StrokeOption&, int value) {
    return value;
}
static json encoded(const StrokeOption&, bool value) {
    return value;
}
static json encoded(const StrokeOption&, const std::string& value) {
    return value.empty() ? json() : json(value);
}
static json encoded(const StrokeOption&, const CurvePoints& points) {
    json out = json::array();
    for (const sculpt::CurvePoint& point : points)
        out.push_back({point.x, point.y});
    return out;
}
static json encoded(const StrokeOption&, const MirrorPlanes& planes) {
    json out = json::array();
    for (const auto& [axis, on] : {std::pair{Axis::X, planes.x}, {Axis::Y, planes.y}, {Axis::Z, planes.z}})
        if (on)
            out.push_back(sculpt::row(axis).id);
    return out;
}
template <class Choice>
static json encoded(const StrokeOption&, Choice value) {
    return sculpt::row(value).id;
}

static void decode(const StrokeOption& option, const json& value, float& out) {
    out = sculpt::storedOf(option, value.get<double>());
}
static void decode(const StrokeOption&, const json& value, int& out) {
    out = value.get<int>();
}
static void decode(const StrokeOption&, const json& value, bool& out) {
    out = value.get<bool>();
}
static void decode(const StrokeOption&, const json& value, std::string& out) {
    out = value.get<std::string>();
}
static void decode(const StrokeOption& option, const json& value, CurvePoints& out) {
    CurvePoints points;
    for (const json& point : value) {
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number())
            throw base::Error("\"" + std::string(option.id) + "\" holds " + shortly(point), {},
                              "it is a list of points [x,y] between 0 and 1, as [[0,1],[0.5,0.8],[1,0]]");
        points.push_back({point[0].get<float>(), point[1].get<float>()});
    }
    sculpt::BrushCurve(points, option.id);
    out = points;
}
static void decode(const StrokeOption& option, const json& value, MirrorPlanes& out) {
    MirrorPlanes planes;
    for (const json& axis : value)
        if (axis == "x")
            planes.x = true;
        else if (axis == "y")
            planes.y = true;
        else if (axis == "z")
            planes.z = true;
        else
            throw base::Error("\"" + std::string(option.id) + "\" holds " + shortly(axis), {},
                              R"(it is a list of "x", "y" and "z")");
    out = planes;
}
static void decode(const StrokeOption&, const json& value, sculpt::Falloff& out) {
    out = sculpt::falloff(value.get<std::string>());
}
static void decode(const StrokeOption&, const json& value, sculpt::StrokeMethod& out) {
    out = sculpt::method(value.get<std::string>());
}
static void decode(const StrokeOption&, const json& value, Axis& out) {
    out = sculpt::axis(value.get<std::string>());
}
static void decode(const StrokeOption&, const json& value, base::UpAxis& out) {
    out = sculpt::upAxis(value.get<std::string>());
}

json valueOf(const StrokeOption& option, const StrokeSettings& settings) {
    return std::visit([&](auto field) { return encoded(option, at(settings, field)); }, option.field);
}

void setValue(const StrokeOption& option, const json& value, StrokeSettings& settings) {
    std::visit([&](auto field) { decode(option, value, at(settings, field)); }, option.field);
}

// --- as a parameter ---

/// Keeps texts that rows point to.
static const char* kept(std::string text) {
    static std::deque<std::string> texts;
    return texts.emplace_back(std::move(text)).c_str();
}

/// A sentence as the command's help says it: in small letters, without its full stop.
static std::string phrase(std::string sentence) {
    if (sentence.ends_with('.'))
        sentence.pop_back();
    sentence.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence.front())));
    return sentence;
}

/// Numbers in as few digits as bring back the float, unlike those of a line, which are those of the double.
static std::string shortest(const json& value) {
    if (value.is_number_float()) {
        char out[40];
        return {out, std::to_chars(out, out + sizeof out, value.get<float>()).ptr};
    }
    if (!value.is_array())
        return value.dump();
    std::string out;
    for (const json& part : value)
        out += (out.empty() ? "" : ",") + shortest(part);
    return "[" + out + "]";
}

static std::string fallbackOf(const StrokeOption& option) {
    switch (option.fallback) {
    case sculpt::Fallback::Field:
        return shortest(valueOf(option, {}));
    case sculpt::Fallback::Tool:
        return "null";
    case sculpt::Fallback::None:
        return "";
    }
    return "";
}

static std::string choicesOf(const StrokeOption& option) {
    const auto ids = [&](auto field) -> std::string {
        using Value = std::decay_t<decltype(at(std::declval<StrokeSettings&>(), field))>;
        if constexpr (std::is_enum_v<Value>)
            return idsOf(sculpt::choicesOf<Value>());
        else
            return {};
    };
    return std::visit(ids, option.field);
}

CommandParameter parameterOf(const StrokeOption& option) {
    const StrokeSettings any;
    const bool number = valueOf(option, any).is_number();
    const bool curve = std::holds_alternative<CurvePoints StrokeSettings::*>(option.field);
    return {option.id,
            std::visit([&](auto field) { return typeOf(at(any, field)); }, option.field),
            option.unit,
            kept(phrase(option.tip) + (curve ? ": 2 to 16 points [x,y], 0 to 1" : "")),
            kept(fallbackOf(option)),
            kept(choicesOf(option)),
            number ? option.range.min : 0,
            number ? option.range.max : 0};
}

// --- as text ---

std::string textOf(const StrokeOption& option, const StrokeSettings& settings) {
    const json value = valueOf(option, settings);
    return value.is_null() ? std::string() : value.is_string() ? value.get<std::string>() : value.dump();
}

/// Texts are texts, whatever they look like.
static bool isText(const StrokeOption& option) {
    return std::holds_alternative<std::string StrokeSettings::*>(option.field) || !choicesOf(option).empty();
}

/// What is no JSON is a text, which no other kind of option takes.
static json valueOf(std::string_view text) {
    try {
        return jsonOf(text);
    } catch (const base::Error&) {
        return text;
    }
}

void setText(const StrokeOption& option, std::string_view text, StrokeSettings& settings) {
    const json value = isText(option) ? json(text) : valueOf(text);
    setValue(option, checked(command("stroke"), option.id, value), settings);
}

} // namespace session
