#include "ui/interaction/picked_outline.h"

#include <nlohmann/json.hpp>

namespace ui {

using nlohmann::json;

static json listOf(const base::Vec3d& v) {
    return {v.x, v.y, v.z};
}

json outlineOf(const Pick& pick, PickShape shape, const base::Vec3d& origin) {
    const render::Camera& camera = pick.camera;
    json out{{"eye", listOf(camera.eye + origin)},
             {"target", listOf(camera.target + origin)},
             {"up", listOf(camera.up)},
             {"size", {camera.width, camera.height}}};
    if (camera.orthoHeight > 0)
        out["ortho"] = camera.orthoHeight;
    else
        out["fov"] = camera.fovDeg;
    if (shape == PickShape::Rectangle) {
        const QPointF &a = pick.corners.front(), &b = pick.corners.back();
        out["rectangle"] = {std::min(a.x(), b.x()), std::min(a.y(), b.y()), std::max(a.x(), b.x()),
                            std::max(a.y(), b.y())};
        return out;
    }
    json& corners = out["polygon"] = json::array();
    for (const QPointF& corner : pick.corners)
        corners.push_back({corner.x(), corner.y()});
    return out;
}

} // namespace ui
