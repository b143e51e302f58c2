#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/session/place_text.h"
#include "core/solid/loops/fill.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace session {

static solid::FillOptions fillOptions(const nlohmann::json& complete) {
    solid::FillOptions out;
    out.shape = complete.at("method") == "flat" ? solid::Shape::Flat : solid::Shape::Smooth;
    out.relief = complete.at("method") == "detail";
    if (const nlohmann::json& holes = complete.at("holes"); holes.is_number())
        out.only = holes.get<std::size_t>();
    else
        out.keepLargest = holes == "largest-kept";
    out.creases = complete.at("creases").get<bool>();
    if (const auto longest = complete.find("up_to"); longest != complete.end())
        out.longest = longest->get<double>();
    return out;
}

static std::string told(const solid::LoopFate& fate, const base::Vec3d& origin) {
    std::ostringstream out;
    out.precision(4);
    out << "boundary loop " << fate.number << " of length " << fate.length << " about "
        << placeText(fate.middle + origin, fate.length);
    if (*fate.why)
        out << " was left: " << fate.why;
    else if (fate.flattened)
        out << " is filled flat: no smooth surface stays near it and clear of the rest";
    else
        out << " is filled smoothly: there is too little around it to follow in relief";
    return out.str();
}

static void fill(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::SurfaceDefinition& definition = context.document.surface().definition();
    if (definition.manifold == surface::Manifold::Surface && std::isinf(definition.boundaryLimit) &&
        !complete.at("holes").is_number()) {
        context.messages.push_back(
            "There is nothing to fill: the surface is closed, or its boundary limit is none; give it a limit, 0.25 for "
            "example, if it has holes.");
        context.instead = std::make_shared<nlohmann::json>(nlohmann::json::array());
        for (const char* figure : {"filled", "left", "surfels"})
            context.figures[figure] = 0;
        return;
    }
    const base::Vec3d origin = context.document.provenance().origin;
    solid::Filled result = solid::fillHoles(context.document.surface(), fillOptions(complete), context.progress);
    std::size_t filled = 0, left = 0, surfels = 0;
    for (const solid::LoopFate& fate : result.loops) {
        if (fate.asked && (*fate.why || fate.flattened || fate.plain))
            context.messages.push_back(told(fate, origin));
        (fate.filled ? filled : left) += 1;
        surfels += fate.surfels;
    }
    context.messages.push_back(std::to_string(filled) + " of " + std::to_string(filled + left) +
                               " boundary loops filled with " + std::to_string(surfels) + " points");
    context.figures["filled"] = static_cast<double>(filled);
    context.figures["left"] = static_cast<double>(left);
    context.figures["surfels"] = static_cast<double>(surfels);
    if (surfels > 0)
        context.document.commit(std::move(result.surface), "Fill holes");
}

CommandRow fillCommand() {
    static const CommandParameter parameters[] = {
        {"holes", "number or choice", "",
         "which boundary loops: all, all but the longest, or one by its number (longest first, from 0)", "\"all\"",
         "all largest-kept", 0, largestCount},
        {"method", "choice", "",
         "flat: as little surface as there can be, in a plane with a sharp edge where a plane cut the model off; "
         "smooth: tangent planes and curvature around go on into the hole; "
         "detail: as smooth, with the relief of what is around",
         "\"smooth\"", "flat smooth detail", 0, 0},
        {"up_to", "number", "model units", "loops longer than this stay open", "null", "", positive, largest},
        creasesParameter(),
    };
    return {"fill",
            "Fill holes",
            "Closes the holes of an open surface with points as dense as those around; loops that touch "
            "themselves are named and stay.",
            parameters,
            true,
            false,
            fill,
            nullptr};
}

} // namespace session
