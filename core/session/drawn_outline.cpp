#include "core/session/drawn_outline.h"

#include "core/base/error.h"
#include "core/session/commands/commands.h"
#include "core/session/number_lists.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

std::vector<CommandParameter> pictureParameters(const char* needed) {
    return {
        {"eye", "list", "model units", "[x,y,z], place of the camera of a view", needed, "", 0, 0},
        {"target", "list", "model units", "[x,y,z], place that the camera looks at", needed, "", 0, 0},
        {"up", "list", "", "[x,y,z], direction that is upwards in the picture; the model's unless told", "null", "", 0,
         0},
        {"fov", "number", "degrees", "vertical angle of view; 35 unless told", "null", "", 1, 170},
        {"ortho", "number", "model units", "parallel rays: height of the picture", "null", "", positive, largest},
        {"size", "list", "pixels", "[width,height], size of the picture; 1280,720 unless told", "null", "", 0, 0},
    };
}

std::vector<CommandParameter> outlineParameters() {
    return {
        {"rectangle", "list", "pixels",
         "[x0,y0,x1,y1], two opposite corners, from the upper left corner of the picture", "null", "", 0, 0},
        {"polygon", "list", "pixels", "[[x,y],...], a lasso: what it goes round, by the even-odd rule", "null", "", 0,
         0},
    };
}

render::Camera cameraOf(const Context& context, const json& complete) {
    render::Camera out;
    out.eye = *placeOf(context, complete, "eye");
    out.target = *placeOf(context, complete, "target");
    out.up = vectorOf(complete, "up").value_or(base::upRow(context.document.up()).up);
    if (complete.contains("fov") && complete.contains("ortho"))
        throw base::Error("\"fov\" and \"ortho\" exclude each other", {}, "give one of them");
    out.fovDeg = complete.value("fov", out.fovDeg);
    out.orthoHeight = complete.value("ortho", 0.0);
    if (complete.contains("size")) {
        const std::vector<double> size = numbersOf(complete, "size", 2, "[width,height]");
        if (!(size[0] >= 1 && size[1] >= 1 && size[0] <= 1e6 && size[1] <= 1e6))
            throw base::Error("\"size\" is no size of a picture", {}, "write [width,height] in pixels");
        out.width = static_cast<int>(size[0]), out.height = static_cast<int>(size[1]);
    }
    if (out.eye == out.target)
        throw base::Error("\"eye\" and \"target\" are the same place", {}, "move one of them");
    return out;
}

std::vector<base::Point2> outlineOf(const json& complete) {
    if (complete.contains("rectangle") == complete.contains("polygon"))
        throw base::Error("an outline is one of rectangle and polygon", {}, "give one of them");
    std::vector<base::Point2> corners;
    if (complete.contains("rectangle")) {
        const std::vector<double> r = numbersOf(complete, "rectangle", 4, "[x0,y0,x1,y1]");
        corners = {{r[0], r[1]}, {r[2], r[1]}, {r[2], r[3]}, {r[0], r[3]}};
    } else {
        for (const json& corner : complete.at("polygon")) {
            const std::vector<double> p =
                numbersOf({{"op", complete.at("op")}, {"polygon", corner}}, "polygon", 2, "[[x,y],[x,y],...]");
            corners.push_back({p[0], p[1]});
        }
        if (corners.size() < 3)
            throw base::Error("\"polygon\" has fewer than three corners", {}, "write [[x,y],[x,y],[x,y],...]");
    }
    return corners;
}

} // namespace session
