#include "core/base/error.h"
#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/session/drawn_outline.h"
#include "core/solid/trim.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// The outline on the plane at depth 1 before the eye; with parallel rays on the one through it.
static solid::OutlineSide sideOf(const render::Camera& camera, const std::vector<base::Point2>& outline) {
    const solid::PictureFrame frame{camera.eye, camera.forward(), camera.right(), camera.upright(), camera.parallel()};
    const double unit = 1 / camera.focalPx();
    std::vector<base::Point2> corners;
    for (const base::Point2& p : outline)
        corners.push_back({(p.x - 0.5 * camera.width) * unit, (0.5 * camera.height - p.y) * unit});
    std::vector<base::Point2> plain = solid::plainOutline(corners);
    if (plain.size() < 3)
        throw base::Error("the outline goes round nothing", "trim", "draw it round a part of the picture");
    return {frame, std::move(plain)};
}

static void trim(Context& context, const json& complete) {
    requireModel(context);
    const solid::OutlineSide side = sideOf(cameraOf(context, complete), outlineOf(complete));
    take(context,
         solid::trimmed(context.document.surface(), side,
                        complete.at("keep") == "inside" ? solid::Trim::Keep : solid::Trim::Away,
                        {complete.at("cap").get<bool>(), complete.at("creases").get<bool>()}, context.progress),
         "Trim");
}

CommandRow trimCommand() {
    static const std::vector<CommandParameter> parameters = [] {
        std::vector<CommandParameter> out = pictureParameters("");
        const std::vector<CommandParameter> outline = outlineParameters();
        out.insert(out.end(), outline.begin(), outline.end());
        out.push_back({"keep", "choice", "", "what stays: all but what the outline goes round, or that alone",
                       "\"outside\"", "outside inside", 0, 0});
        out.push_back(
            {"cap", "boolean", "", "close what was cut, as dense as the model is beside it", "true", "", 0, 0});
        out.push_back(creasesParameter());
        return out;
    }();
    return {"trim",     "Trim", "Cuts along an outline drawn in a picture of the model, straight through it.",
            parameters, true,   false,
            trim,       nullptr};
}

} // namespace session
