// What the native format says in comment lines of a PLY file, so that every other program can still read it:
//
//     comment pointclay origin X Y Z             the model's origin; always there, and makes the file a native one
//     comment pointclay normals oriented         or "unoriented": whether the signs of normals agree
//     comment pointclay up z                     the axis that is upwards: x, y, z, -x, -y or -z
//     comment pointclay surface frame=normals...  the surface definition, in the words of surface/definition_text.h
#pragma once

#include "core/base/up_axis.h"
#include "core/surface/definition.h"

#include <optional>
#include <string>
#include <vector>

namespace io {

struct NativeComments {
    std::optional<base::Vec3d> origin;
    std::optional<bool> oriented;
    std::optional<base::UpAxis> up;
    std::optional<surface::SurfaceDefinition> definition;
    bool limitDecided = false; ///< the definition's line says what Boundary::Auto was resolved to
};

/// Takes our lines out of `comments`. Lines of ours that cannot be understood are dropped with a message.
NativeComments takeNativeComments(std::vector<std::string>& comments, std::vector<std::string>& messages);

/// The lines, each ended by \n. REQUIRES: an origin.
std::string nativeCommentLines(const NativeComments& native);

} // namespace io
