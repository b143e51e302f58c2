// Outlines drawn in a picture as parameters: where it is seen from, and a rectangle or a polygon in its pixels. Inside
// this room.
#pragma once

#include "core/base/outline.h"
#include "core/render/camera.h"
#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace session {

/// eye, target, up, fov, ortho and size; eye and target have the default that is told ("" where they are needed).
std::vector<CommandParameter> pictureParameters(const char* needed);
/// rectangle and polygon.
std::vector<CommandParameter> outlineParameters();

/// In stored coordinates. REQUIRES: eye and target are there. Throws base::Error.
render::Camera cameraOf(const Context& context, const nlohmann::json& complete);
/// In pixels. Throws base::Error unless one of rectangle and polygon is there, with three corners or more.
std::vector<base::Point2> outlineOf(const nlohmann::json& complete);

} // namespace session
