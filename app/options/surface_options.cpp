#include "app/options/surface_options.h"

#include "core/base/error.h"
#include "core/io/number_text.h"
#include "core/session/surface_options.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace app {

using nlohmann::json;
using session::CommandParameter;

/// A number where the text is one, else the text: what the session's check wants to see.
static json valueOf(const std::string& text) {
    if (const auto count = io::countOf(text))
        return *count;
    const auto number = io::numberOf(text);
    return number && std::isfinite(*number) ? json(*number) : json(text);
}

json SurfaceOptions::parameters() const {
    json out = json::object();
    for (const auto& [name, value] : given)
        out[name] = valueOf(value);
    return out;
}

/// What holds where nobody has said otherwise; "" where that is nothing.
static std::string fallbackOf(const CommandParameter& p) {
    const surface::DefinitionOption& option = surface::definitionOption(p.id);
    return option.range.orZero ? "" : surface::textOf(option, {});
}

static std::string helpOf(const CommandParameter& p) {
    const std::string_view type = p.type;
    std::string choices = type == "boolean" ? "on off" : p.choices;
    for (char& c : choices)
        c = c == ' ' ? '|' : c;
    std::string out = p.tip;
    if (*p.unit)
        out += std::string(", in ") + p.unit;
    if (!choices.empty())
        out += ": " + (type == "number or choice" ? "LIMIT|" + choices : choices);
    const std::string fallback = fallbackOf(p);
    return fallback.empty() ? out : out + " [" + fallback + ", or what the file says]";
}

/// The session's own check of one value: "" where it is all right.
static std::string fault(const std::string& id, const std::string& value) {
    try {
        session::complete({{"op", "surface"}, {id, valueOf(value)}});
        return {};
    } catch (const base::Error& error) {
        return error.message();
    }
}

std::shared_ptr<SurfaceOptions> addSurfaceOptions(CLI::App& command, bool withPrecision) {
    auto options = std::make_shared<SurfaceOptions>();
    std::map<std::string, CLI::Option*> added;
    for (const CommandParameter& p : session::surfaceParameters()) {
        const std::string id = p.id;
        CLI::Option* option = command.add_option_function<std::string>(
            "--" + id, [options, id](const std::string& value) { options->given.emplace_back(id, value); }, helpOf(p));
        option->group("Surface")->check([id](const std::string& value) { return fault(id, value); });
        added[id] = option;
        if (const char* other = surface::definitionOption(id).excludes)
            option->excludes(added.at(other));
    }
    if (withPrecision)
        command
            .add_option("--precision", options->precision, "arithmetic, and digits written: 9 for float, 17 for double")
            ->group("Surface")
            ->check(CLI::IsMember({"float", "double"}))
            ->capture_default_str();
    return options;
}

} // namespace app
