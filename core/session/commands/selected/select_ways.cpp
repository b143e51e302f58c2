#include "core/session/commands/selected/select_ways.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/selection/field.h"
#include "core/selection/flood.h"
#include "core/selection/quantities.h"
#include "core/selection/regions.h"
#include "core/selection/rims.h"
#include "core/selection/view_region.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/drawn_outline.h"
#include "core/session/number_lists.h"

#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

namespace session {

using base::Vec3d;
using nlohmann::json;
using tree::Selection;

namespace {

constexpr double radians = std::numbers::pi / 180;

const surface::Surface& surfaceOf(const Context& context) {
    return context.document.surface();
}

struct Everything {
    bool holds(const Vec3d&) const { return true; }
    selection::Relation relation(const base::Box3d&) const { return selection::Relation::Inside; }
};

Selection all(Context& context, const json&) {
    return selection::within(surfaceOf(context).tree(), Everything());
}

Selection none(Context&, const json&) {
    return {};
}

Selection inBall(Context& context, const json& complete) {
    return selection::within(surfaceOf(context).tree(),
                             selection::BallRegion{*placeOf(context, complete, "at"), complete.at("radius")});
}

Selection inBox(Context& context, const json& complete) {
    const base::Box3d box{*placeOf(context, complete, "least"), *placeOf(context, complete, "most")};
    if (box.empty())
        throw base::Error("\"least\" lies beyond \"most\"", {}, "give the corner with the smaller numbers first");
    return selection::within(surfaceOf(context).tree(), selection::BoxRegion{box});
}

Selection abovePlane(Context& context, const json& complete) {
    return selection::within(surfaceOf(context).tree(), selection::PlaneRegion{planeOf(context, complete, "plane")});
}

Selection inView(Context& context, const json& complete) {
    selection::ViewRegion region(cameraOf(context, complete), base::Outline(outlineOf(complete)));
    if (complete.contains("depth")) {
        const std::vector<double> depth = numbersOf(complete, "depth", 2, "[from,to]");
        region.nearest = depth[0], region.farthest = depth[1];
    }
    if (complete.value("visible", false))
        requireSurface(context);
    const Selection through = selection::within(surfaceOf(context).tree(), region);
    return complete.value("visible", false) ? selection::visibleOf(surfaceOf(context), region.camera, through)
                                            : through;
}

Selection inRange(Context& context, const json& complete) {
    if (complete.at("of").get<std::string>().starts_with("curvature-"))
        requireSurface(context);
    return selection::inRange(surfaceOf(context), complete.at("of").get<std::string>(),
                              complete.value("from", -largest), complete.value("to", largest),
                              context.document.provenance().origin, context.progress);
}

Selection ofColour(Context& context, const json& complete) {
    return selection::nearColour(surfaceOf(context).tree(), colourOf(complete, "colour"),
                                 complete.value("tolerance", 32.0));
}

Selection byNormal(Context& context, const json& complete) {
    const Vec3d direction = *vectorOf(complete, "direction");
    if (!(length(direction) > 0))
        throw base::Error("\"direction\" is zero", {}, "give it a length");
    return selection::facing(surfaceOf(context).tree(), direction, complete.value("angle", 30.0) * radians);
}

/// From the surfel nearest to "at", else from what is selected.
Selection ofPiece(Context& context, const json& complete) {
    const surface::Surface& surface = surfaceOf(context);
    const std::optional<Vec3d> at = placeOf(context, complete, "at");
    const Selection seeds = at ? selection::nearestTo(surface.tree(), *at) : selection::selectedIn(surface.tree());
    if (seeds.empty())
        throw base::Error("there is nothing selected to begin with", {}, "say where to begin: \"at\":[x,y,z]");
    selection::FloodLimits limits;
    limits.hidden = complete.at("hidden");
    if (complete.contains("curvature"))
        requireSurface(context);
    limits.angleRad = complete.value("angle", 180.0) * radians;
    limits.curvature = complete.value("curvature", std::numeric_limits<double>::infinity());
    return selection::flooded(surface, seeds, limits, context.progress);
}

Selection onRims(Context& context, const json& complete) {
    requireSurface(context);
    selection::RimQuestion question;
    question.at = placeOf(context, complete, "at");
    question.longest = complete.value("longest", std::numeric_limits<double>::infinity());
    question.width = complete.value("width", 0.0);
    const Selection out = selection::alongRims(surfaceOf(context), question, context.progress);
    if (out.empty())
        context.messages.push_back("The surface has no such boundary.");
    return out;
}

constexpr SelectWay ways[] = {
    {"all", "", "", all},
    {"none", "", "", none},
    {"ball", "at radius", "", inBall},
    {"box", "least most", "", inBox},
    {"plane", "plane", "", abovePlane},
    {"view", "eye target", "up fov ortho size rectangle polygon depth visible", inView},
    {"range", "of", "from to", inRange},
    {"colour", "colour", "tolerance", ofColour},
    {"normal", "direction", "angle", byNormal},
    {"piece", "", "at angle curvature", ofPiece},
    {"rim", "", "at longest width", onRims},
};

bool names(const std::string& words, const std::string& id) {
    std::istringstream in(words);
    for (std::string word; in >> word;)
        if (word == id)
            return true;
    return false;
}

} // namespace

std::span<const SelectWay> selectWays() {
    return ways;
}

Selection found(Context& context, const json& complete) {
    const auto by = complete.at("by").get<std::string>();
    const SelectWay& way = *base::findRow(ways, by);
    std::istringstream needs(way.needs);
    for (std::string id; needs >> id;)
        if (!complete.contains(id))
            throw base::Error("\"select\" by " + by + " needs the parameter \"" + id + "\"");
    for (const auto& [key, value] : complete.items())
        if (key != "op" && key != "by" && key != "mode" && key != "hidden" && !names(way.needs, key) &&
            !names(way.takes, key))
            throw base::Error("\"" + key + "\" has no say in \"select\" by " + by, {}, "leave it out");
    return way.find(context, complete);
}

} // namespace session
