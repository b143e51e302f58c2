#include "core/base/error.h"
#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/session/number_lists.h"
#include "core/solid/tube.h"
#include "core/surface/rays/intersect.h"

#include <nlohmann/json.hpp>

namespace session {

using base::Vec3d;
using nlohmann::json;

/// The surfel nearest to the place and the length of its support tell whether the surface can be within `reach`.
static bool isNear(const surface::Surface& model, const Vec3d& place, double reach) {
    std::vector<tree::Neighbour> near;
    model.tree().nearest(base::cast<float>(place), 1, near);
    const tree::Neighbour& at = near.front();
    return base::distance(base::cast<double>(at.block->position(at.slot)), place) <
           reach + static_cast<double>(at.block->support(at.slot));
}

/// Throws where the tube is too narrow for a seam. Of each piece of the line, the first and the last place on the
/// surface are looked at.
static void requireWidthAlong(const surface::Surface& model, const std::vector<Vec3d>& line, double radius) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double length = base::distance(line[i], line[i + 1]);
        if (!(length > 0) || !isNear(model, line[i], length))
            continue;
        for (const auto& [from, to] : {std::pair(line[i], line[i + 1]), std::pair(line[i + 1], line[i])}) {
            const auto hit = surface::intersectReference(model, {from, base::normalized(to - from)});
            if (hit.hit && hit.t <= length)
                requireWidth(model, hit.position, radius, "tube", "tube");
        }
    }
}

static void tube(Context& context, const json& complete) {
    requireModel(context);
    const surface::Surface& model = context.document.surface();
    const auto radius = complete.at("radius").get<double>();
    std::vector<Vec3d> line =
        solid::curveThrough(placesOf(context, complete, "along"), radius, complete.at("smooth").get<bool>());
    if (line.size() < 2)
        throw base::Error("\"along\" has fewer than two places", "tube", "give two at least, with three numbers each");
    requireWidthAlong(model, line, radius);
    constexpr double finest = 0.4; // radii: a dozen points around it at least
    const double spacing = complete.contains("spacing") ? complete.at("spacing").get<double>()
                                                        : std::min(spacingNear(model, line.front()), finest * radius);
    const solid::TubeSide side(std::move(line), radius);
    tellOfGuess(context, model);
    takeBoth(context,
             solid::combine(model, {side, solid::surfelsOf(side, spacing, model.definition())},
                            solid::operation(complete.at("operation").get<std::string>()), combineOptions(complete),
                            context.progress),
             "Tube");
}

CommandRow tubeCommand() {
    static const std::string operations = idsOf(solid::operationTable());
    static const CommandParameter parameters[] = {
        {"along", "list", "model units",
         "[[x,y,z],...], places that its middle goes through; closed where the last is the first", "", "", 0, 0},
        {"radius", "number", "model units", "of the tube, whose ends are round", "", "", positive, largest},
        {"smooth", "boolean", "",
         "a centripetal Catmull-Rom curve through the places; off: straight lines, with round joints", "true", "", 0,
         0},
        {"operation", "choice", "", "union joins it, difference takes it away, intersection keeps what is in it",
         "\"union\"", operations.c_str(), 0, 0},
        {"spacing", "number", "model units",
         "of its points; by default as the model's nearest to its beginning, 0.4 radii at most", "null", "", positive,
         largest},
        creasesParameter(),
        filletParameter(),
        chamferParameter(),
    };
    return {"tube",     "Add a tube", "Joins a tube along a curve to the model, or takes it away: a handle, a channel.",
            parameters, true,         false,
            tube,       nullptr};
}

} // namespace session
