#include "core/base/error.h"
#include "core/selection/field.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/number_text_list.h"
#include "core/session/place_text.h"
#include "core/solid/extrude/extrude.h"

#include <nlohmann/json.hpp>

namespace session {

/// What ran through the model, and what became or could become of it.
static void tellCrossings(Context& context, const solid::Extruded& result, const nlohmann::json& complete) {
    const bool merge = complete.at("merge"), selected = complete.at("what") == "selection";
    context.figures["crossings"] = static_cast<double>(result.crossings.rays);
    if (result.crossings.rays == 0)
        return;
    const std::string where = "near " +
                              placeText(result.crossings.place + context.document.provenance().origin,
                                        std::abs(complete.at("length").get<double>())) +
                              " it runs through the model";
    if (merge && result.inside == 0)
        context.messages.push_back("On its way " + where +
                                   ", or lies on it, but no points are inside of each other, and nothing was merged; a "
                                   "shorter length keeps clear, a longer one goes through.");
    else
        context.messages.push_back(merge ? "On its way " + where + ": " + std::to_string(result.inside) +
                                               " points inside of each other went, and both are one."
                                         : "On its way " + where + ", or lies on it; a shorter length keeps clear" +
                                               (selected ? ", \"merge\" makes one solid of both." : "."));
}

static void extrude(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    solid::ExtrudeOptions options;
    options.length = complete.at("length");
    options.creases = complete.at("creases");
    options.merge = complete.at("merge");
    if (complete.contains("direction"))
        options.direction = directionOf(complete.at("direction").get<std::string>(), "direction");
    const bool selected = complete.at("what") == "selection";
    if (selected && complete.contains("loop"))
        throw base::Error("\"loop\" has no say where a selection is extruded", {},
                          "leave it out, or say \"what\":\"loop\"");
    if (!selected && options.merge)
        throw base::Error("\"merge\" has no say where a wall is put along a loop: what is open bounds no solid", {},
                          "leave it out");
    if (selected)
        requireSelection(context);
    const surface::Surface& surface = context.document.surface();
    const auto loop = complete.contains("loop") ? std::optional(complete.at("loop").get<std::size_t>()) : std::nullopt;
    solid::Extruded result =
        selected ? solid::extrudeSelected(surface, selection::selectedIn(surface.tree()), options, context.progress)
                 : solid::extrudeLoop(surface, loop, options, context.progress);
    context.messages.push_back(
        (selected ? std::to_string(result.moved) + " points were moved, and walls of " : "A wall of ") +
        std::to_string(result.walls) + (selected ? " points were added" : " points was added") +
        (result.atEdge > 0 ? "; its edges are sharp." : "."));
    tellCrossings(context, result, complete);
    context.figures["moved"] = static_cast<double>(result.moved);
    context.figures["walls"] = static_cast<double>(result.walls);
    context.document.commit(std::move(result.surface), "Extrude", layers::How::Keep);
}

CommandRow extrudeCommand() {
    static const CommandParameter parameters[] = {
        {"what", "choice", "",
         "selection: what is selected moves away, and walls close the step; loop: a wall along a boundary loop",
         "\"selection\"", "selection loop", 0, 0},
        {"length", "number", "model units", "how far; below 0 the other way", "", "", -largest, largest},
        {"direction", "text", "",
         "where to: x,y,z; a selection goes along its mean normal unless told, a wall along its loop stands across the "
         "surface",
         "null", "", 0, 0},
        {"loop", "integer", "",
         "which boundary loop: longest first, from 0, as boundary lists them; may be left out where there is one",
         "null", "", 0, largestCount},
        {"merge", "boolean", "",
         "where what moves runs through the model: what is inside of each other goes, and both are one solid, or "
         "a hole goes through",
         "false", "", 0, 0},
        {"creases", "boolean", "", "edges stay sharp; else they are round over about a support", "true", "", 0, 0},
    };
    return {"extrude",
            "Extrude",
            "Draws a part of the model out, with walls that close the step, or puts a wall along a boundary loop.",
            parameters,
            true,
            false,
            extrude,
            nullptr};
}

} // namespace session
