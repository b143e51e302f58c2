// Materials of an OBJ file: of its libraries (.mtl) what paints faces, `Kd` and `map_Kd`.
#pragma once

#include "core/io/pictures/face_pictures.h"

#include <map>
#include <optional>

namespace io {

/// What of a material paints a face: its picture, and where that is missing its colour.
struct ObjMaterial {
    PictureName picture;
    std::optional<surfel::Colour> colour;
    /// Where a corner's place (u, v) lies in the picture: (scale u + offset u, scale v + offset v).
    double scale[2] = {1, 1}, offset[2] = {0, 0};
};

/// The materials that paint anything, by their names. `libraries`: what stands behind `mtllib`. A library that is
/// missing in the model's folder paints nothing, and is told in `messages`.
std::map<std::string, ObjMaterial, std::less<>> readMaterials(const std::filesystem::path& folder,
                                                              const std::vector<std::string>& libraries,
                                                              std::vector<std::string>& messages);

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

} // namespace io
