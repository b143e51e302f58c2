// Lists of numbers as parameters: places, directions, planes, colours. Inside this room.
#pragma once

#include "core/base/plane.h"
#include "core/session/command.h"
#include "core/surfel/surfel.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace session {

/// The numbers of a parameter, which must be `count` finite ones; `wish` shows how to write them: "[x,y,z]". Throws
/// base::Error.
std::vector<double> numbersOf(const nlohmann::json& complete, const char* id, std::size_t count, const char* wish);

/// None where the parameter was left out.
std::optional<base::Vec3d> vectorOf(const nlohmann::json& complete, const char* id);
/// In stored coordinates: less the model's origin.
std::optional<base::Vec3d> placeOf(const Context& context, const nlohmann::json& complete, const char* id);
/// [[x,y,z], ...] or [x,y,z, x,y,z, ...], one at least, relative to the model's origin. Throws base::Error.
std::vector<base::Vec3d> placesOf(const Context& context, const nlohmann::json& complete, const char* id);
/// [nx,ny,nz,d], the half where n . x >= d, made unit and relative to the model's origin. Throws base::Error where n is
/// zero.
base::Plane planeOf(const Context& context, const nlohmann::json& complete, const char* id);
struct Turn {
    base::Vec3d axis; ///< not zero
    double angle = 0; ///< radians
};
/// "axis" and "angle", of which neither or both are there. Throws base::Error.
std::optional<Turn> turnOf(const nlohmann::json& complete);
/// [red,green,blue], each 0 to 255. Throws base::Error.
surfel::Colour colourOf(const nlohmann::json& complete, const char* id);

} // namespace session
