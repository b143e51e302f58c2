#include "core/base/error.h"
#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/session/number_text_list.h"
#include "core/solid/cut.h"

#include <nlohmann/json.hpp>

namespace session {

base::Plane planeOf(const std::string& text, const base::Vec3d& origin) {
    const std::vector<double> n = numbersOf(text, "plane", 4, 4);
    const base::Vec3d normal{n[0], n[1], n[2]};
    const double scale = length(normal);
    if (!(scale > 0))
        throw base::Error("'" + text + "' has a normal of no length", "plane", "write nx,ny,nz,d");
    return base::Plane{normal / scale, n[3] / scale}.relativeTo(origin);
}

static void cut(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    base::Plane plane = planeOf(complete.at("plane").get<std::string>(), context.document.provenance().origin);
    if (complete.at("keep") == "below")
        plane = plane.flipped();
    take(context,
         solid::cutByPlane(context.document.surface(), plane,
                           {complete.at("cap").get<bool>(), complete.at("creases").get<bool>()}, context.progress),
         "Cut");
}

CommandRow cutCommand() {
    static const CommandParameter parameters[] = {
        {"plane", "text", "", "the points where nx*x + ny*y + nz*z = d, as nx,ny,nz,d", "", "", 0, 0},
        {"keep", "choice", "", "which side stays; above is where the plane's normal points to", "\"above\"",
         "above below", 0, 0},
        {"cap", "boolean", "", "close what was cut, as dense as the model is beside it", "true", "", 0, 0},
        creasesParameter(),
    };
    return {"cut", "Cut", "Cuts the model by a plane and keeps one side.", parameters, true, false, cut, nullptr};
}

} // namespace session
