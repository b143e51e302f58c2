// What the commands share that put a model and a solid together. Inside this room only.
#pragma once

#include "core/base/plane.h"
#include "core/session/command.h"
#include "core/solid/combine.h"
#include "core/solid/primitive.h"

namespace session {

/// The result becomes the document's, with a message and figures of what came and went; or why nothing did.
void take(Context& context, solid::Combined result, const char* label,
          const std::string& unchanged = "no point went, and none came");

/// As take, of the model and another surface; tells where they do not meet.
void takeBoth(Context& context, solid::Combined result, const char* label);

/// Tells that what is inside of an open surface is a guess. Returns whether it is open.
bool tellOfGuess(Context& context, const surface::Surface& surface, const char* name = "model");

/// "creases": are seams sharp? "fillet": or rounded by a ball? "chamfer": or cut flat?
CommandParameter creasesParameter();
CommandParameter filletParameter();
CommandParameter chamferParameter();
/// Of a command that has all of them. Throws base::Error where they exclude each other.
solid::CombineOptions combineOptions(const nlohmann::json& complete);

/// "nx,ny,nz,d" in coordinates of the file, relative to the model's origin. Throws base::Error.
base::Plane planeOf(const std::string& text, const base::Vec3d& origin);

/// Between surfels where the model is nearest to a place. REQUIRES: a model.
double spacingNear(const surface::Surface& model, const base::Vec3d& place);

/// Throws base::Error of `command` where something round of that radius, such as a "hole", that goes through the
/// surface at `place` is too narrow for the points there: no seam would be found, and both would only run through each
/// other.
void requireWidth(const surface::Surface& model, const base::Vec3d& place, double radius, const char* what,
                  const char* command);

/// "position" and "rotation" of a command, relative to the model's origin.
solid::Pose poseOf(const nlohmann::json& complete, const base::Vec3d& origin);

} // namespace session
