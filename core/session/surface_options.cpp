#include "core/session/surface_options.h"

#include "core/base/error.h"
#include "core/session/commands/commands.h"
#include "core/surface/definition_text.h"
#include "core/surface/frames/frame_table.h"

#include <deque>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

using surface::DefinitionOption;

static const char* typeOf(const DefinitionOption& option) {
    struct Type {
        const char* operator()(float surface::SurfaceDefinition::*) const { return "number"; }
        const char* operator()(int surface::SurfaceDefinition::*) const { return "integer"; }
        const char* operator()(bool surface::SurfaceDefinition::*) const { return "boolean"; }
        const char* operator()(surface::BoundaryField) const { return "number or choice"; }
        const char* operator()(...) const { return "choice"; }
    };
    return std::visit(Type{}, option.field);
}

std::span<const CommandParameter> surfaceParameters() {
    static std::deque<std::string> choices; // outlive the rows that point to them
    static const std::vector<CommandParameter> rows = [] {
        std::vector<CommandParameter> out;
        for (const DefinitionOption& option : surface::definitionOptionTable())
            if (option.chosenBy == surface::ChosenBy::Person)
                out.push_back({option.id, typeOf(option), option.unit, option.tip, "null",
                               choices.emplace_back(surface::choicesOf(option)).c_str(), option.range.min,
                               option.range.max});
        return out;
    }();
    return rows;
}

static std::string textOf(const json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_boolean() ? (value ? "on" : "off") : value.dump();
}

static void refuseExclusive(const DefinitionOption& option, const json& complete) {
    if (option.excludes && complete.contains(option.excludes))
        throw base::Error("\"" + std::string(option.excludes) + "\" and \"" + option.id + "\" exclude each other", {},
                          "give one of them");
}

static std::string framesOfCurves() {
    std::string out;
    for (const surface::FrameRow& row : surface::frameTable)
        if (row.onCurves || row.reads == surface::NormalsRead::Unoriented)
            out.append(out.empty() ? "" : ", ").append(row.name);
    return out;
}

static void refuseSurfaceFrameOnCurve(const surface::SurfaceDefinition& definition) {
    const surface::FrameRow& frame = surface::rowOf(definition.frame);
    if (definition.manifold == surface::Manifold::Curve && frame.ownField)
        throw base::Error("the frame " + std::string(frame.name) + " defines surfaces, not curves", {},
                          "choose one of " + framesOfCurves());
}

SurfaceChange changed(const surface::SurfaceDefinition& base, const json& complete) {
    SurfaceChange out{base, false};
    for (const DefinitionOption& option : surface::definitionOptionTable())
        if (option.chosenBy == surface::ChosenBy::Person && complete.contains(option.id)) {
            refuseExclusive(option, complete);
            surface::setText(option, out.definition, textOf(complete[option.id]));
        }
    const bool support = complete.contains("support"), neighbours = complete.contains("neighbours");
    if (neighbours)
        out.definition.support = 0;
    refuseSurfaceFrameOnCurve(out.definition);
    out.newSupports = support || neighbours || out.definition.weight != base.weight;
    return out;
}

std::vector<CommandParameter> withSurfaceParameters(std::span<const CommandParameter> own) {
    std::vector<CommandParameter> out(own.begin(), own.end());
    out.insert(out.end(), surfaceParameters().begin(), surfaceParameters().end());
    return out;
}

} // namespace session
